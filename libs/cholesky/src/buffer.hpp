#pragma once

#include <cstddef>
#include <cstdint>
#include <new>

namespace isostretch::cholesky {

// Numbers on cache lines of their own, not set to anything.
class Buffer {
 public:
  Buffer() = default;
  ~Buffer() { free(); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  Buffer(Buffer&& other) noexcept : data_(other.data_) { other.data_ = nullptr; }

  // False where there is no memory.
  bool allocate(std::int64_t values) {
    free();
    data_ = static_cast<double*>(::operator new(static_cast<std::size_t>(values) * sizeof(double),
                                                std::align_val_t(64), std::nothrow));
    return data_ != nullptr;
  }

  double* data() const { return data_; }

 private:
  void free() noexcept {
    ::operator delete(data_, std::align_val_t(64));
    data_ = nullptr;
  }

  double* data_ = nullptr;
};

}  // namespace isostretch::cholesky

#pragma once

#include <cstddef>
#include <cstdint>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace isostretch::cholesky {

// Numbers on cache lines of their own, not set to anything.
class Buffer {
 public:
  Buffer() = default;
  ~Buffer() { free(); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  // Keeps what is there where that is enough. False where there is no memory.
  bool provide(std::int64_t values) {
    if (values <= values_) return true;
    free();
    const std::size_t bytes = static_cast<std::size_t>(values) * sizeof(double);
    alignment_ = std::align_val_t(bytes < large ? cache_line : huge_page);
    data_ = static_cast<double*>(::operator new(bytes, alignment_, std::nothrow));
#if defined(__linux__)
    // Touched for the first time by pages of 4 KB, a large factor can cost more than its factorization. Where
    // the system has no large pages to give, nothing is lost.
    if (data_ != nullptr && bytes >= large) ::madvise(data_, bytes / huge_page * huge_page, MADV_HUGEPAGE);
#endif
    if (data_ != nullptr) values_ = values;
    return data_ != nullptr;
  }

  double* data() const {
    return data_;
  }

 private:
  void free() noexcept {
    ::operator delete(data_, alignment_);
    data_ = nullptr;
    values_ = 0;
  }

  static constexpr std::size_t cache_line = 64, huge_page = std::size_t(1) << 21,
                               large = std::size_t(1) << 25;
  double* data_ = nullptr;
  std::int64_t values_ = 0;
  std::align_val_t alignment_{cache_line};
};

}  // namespace isostretch::cholesky

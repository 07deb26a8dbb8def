#pragma once

#include <cstddef>
#include <memory>

namespace isostretch {

// Bump allocator of one thread for the arrays of one chunk: structure-of-arrays scratch that stays in cache
// and costs nothing to hand out. Blocks are aligned to 64 bytes and live until reset(); memory is kept for
// the next chunk.
class Arena {
 public:
  explicit Arena(std::size_t bytes = 0);
  ~Arena();
  Arena(Arena&&) noexcept;
  Arena& operator=(Arena&&) noexcept;

  // Uninitialised space for `count` doubles. Throws Error when the capacity given at construction is
  // exceeded: a chunk has a known size, so running over it is a programming error and must not silently
  // become a heap allocation.
  double* doubles(std::size_t count);

  void reset() noexcept { used_ = 0; }
  std::size_t capacity() const noexcept { return capacity_; }

 private:
  struct Free {
    void operator()(std::byte* memory) const noexcept;
  };
  std::unique_ptr<std::byte[], Free> memory_;
  std::size_t capacity_ = 0;
  std::size_t used_ = 0;
};

}  // namespace isostretch

#pragma once

#include <cstddef>
#include <memory>

namespace isostretch {

/// A bump allocator of one thread for the arrays of one chunk: structure-of-arrays scratch memory that stays
/// in cache and costs nothing to hand out. Blocks are aligned to 64 bytes and live until reset(), which keeps
/// the memory for the next chunk.
class Arena {
 public:
  /// Allocates a capacity of `bytes` bytes, all that doubles() may hand out between two calls of reset().
  explicit Arena(std::size_t bytes = 0);
  ~Arena();
  /// Takes over the memory of the other arena, which is left to be destroyed or assigned to.
  Arena(Arena&&) noexcept;
  /// Frees this memory and takes over that of the other arena, which is left to be destroyed or assigned to.
  Arena& operator=(Arena&&) noexcept;

  /// Returns uninitialised space for `count` doubles. Throws Error where the capacity is exceeded: the size
  /// of a chunk is known, so running over it is a programming error and must not become a heap allocation
  /// unnoticed.
  double* doubles(std::size_t count);

  /// Makes the whole capacity available again; blocks handed out before are invalid.
  void reset() noexcept { used_ = 0; }
  /// Returns the capacity in bytes.
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

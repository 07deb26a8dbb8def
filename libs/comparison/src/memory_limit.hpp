#pragma once

#include <sys/resource.h>

namespace isostretch::comparison {

// As long as it lives this process, and what it starts, gets no more memory than that: megabytes of address
// space, which is more than what is used. What would need more fails as if the machine had none. 0: no limit.
// Throws Error where the system refuses.
class MemoryLimit {
 public:
  explicit MemoryLimit(double megabytes);
  ~MemoryLimit();
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{};
  bool is_set_ = false;
};

}  // namespace isostretch::comparison

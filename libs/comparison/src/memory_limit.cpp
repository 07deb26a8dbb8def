#include "memory_limit.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>

namespace isostretch::comparison {

MemoryLimit::MemoryLimit(double megabytes) {
  const double bytes = megabytes * 1024 * 1024;
  constexpr double most = 1e18;  // beyond any machine, and within rlim_t
  if (!(bytes > 0) || bytes >= most) return;
  if (getrlimit(RLIMIT_AS, &before_) == 0) {
    rlimit limit = before_;
    limit.rlim_cur = std::min(static_cast<rlim_t>(bytes), before_.rlim_max);
    is_set_ = setrlimit(RLIMIT_AS, &limit) == 0;
  }
  if (!is_set_) throw Error("the memory of this process cannot be limited");
}

MemoryLimit::~MemoryLimit() {
  if (is_set_) setrlimit(RLIMIT_AS, &before_);
}

}  // namespace isostretch::comparison

#pragma once

#include <algorithm>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace isostretch::sparse {

// Calls body(begin, end, part) for ranges that make up 0 .. count, one per thread, and waits for them; part
// is less than max_parts(), for work space. Fewer than `least` items are not worth a thread. What body
// computes of an item must not depend on the range the item is in: then results do not depend on threads. No
// exception may leave body (allocate outside). Without OpenMP there is one range.
inline int max_parts() {
#if defined(_OPENMP)
  return std::max(1, omp_get_max_threads());
#else
  return 1;
#endif
}

template <class Body>
void for_ranges(int count, int least, const Body& body) {
  [[maybe_unused]] const int parts = std::clamp(count / least, 1, max_parts());
#if defined(_OPENMP)
  if (parts > 1) {
#pragma omp parallel for schedule(static, 1) num_threads(parts)
    for (int part = 0; part < parts; ++part) {
      const auto at = [&](int p) { return static_cast<int>(static_cast<long long>(count) * p / parts); };
      body(at(part), at(part + 1), part);
    }
    return;
  }
#endif
  body(0, count, 0);
}

}  // namespace isostretch::sparse

#pragma once

#include "schedule.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace isostretch::cholesky {

// Where the update matrices lie that units of a schedule hand to their parents, and the stacks on which
// threads keep those within subtrees. They take the place of columns of L: each lies where, as long as it is
// needed, no columns have been begun and no other one lies, or else beyond L. When that is, a simulation of
// so many threads says. A unit waits for the last one that needs what lies in its place, so that nothing
// depends on how long units really take. Update matrices that a refactorization takes from the factorization
// before are kept, and what it makes anew lies beside all that is.
struct Storage {
  std::vector<std::int64_t> update;  // of every unit: place of its update matrix, from the beginning of L
  std::vector<std::int64_t> stack;   // of every thread
  std::int64_t values = 0;           // of L and the space beyond it
  // The second waits for the first, besides parents for children; ascending.
  std::vector<std::pair<int, int>> waits;
  int threads = 1;  // that can be at work at the same time, no more than were asked for
  // Operations with those below up to which a unit is one thread's. Those above are done by all, in turn.
  double alone = 0;

  Storage() = default;
  Storage(const Structure& structure, const Schedule& schedule, int most_threads);
};

}  // namespace isostretch::cholesky

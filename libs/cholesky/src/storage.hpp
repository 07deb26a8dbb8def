#pragma once

#include "schedule.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace isostretch::cholesky {

// Where the update matrices lie that units of a schedule hand to their parents, and the stacks on which
// threads keep those within subtrees: among the columns of L that are not begun before nobody needs them any
// more, and in some space beyond L. When that is, a simulation of so many threads says. A unit waits for the
// last one that needs what lies in its place, so that nothing depends on how long units really take. Update
// matrices that a refactorization takes from the factorization before are kept, and what it makes anew lies
// beside all that is.
struct Storage {
  std::vector<std::int64_t>
      update;  // of every unit: place of its update matrix, in values from the beginning of L
  std::vector<std::int64_t> stack;  // of every thread
  std::int64_t values = 0;          // of L and the space beyond it
  std::vector<std::pair<int, int>>
      waits;         // the second waits for the first, besides parents for children; ascending
  double alone = 0;  // operations up to which a subtree is the work of single threads; those above are done
                     // in turn by all

  Storage() = default;
  Storage(const Structure& structure, const Schedule& schedule, int threads);
};

}  // namespace isostretch::cholesky

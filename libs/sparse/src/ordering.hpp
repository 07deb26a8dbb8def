#pragma once

#include <isostretch/sparse/matrix.hpp>
#include <isostretch/sparse/solver.hpp>

#include <vector>

namespace isostretch::sparse {

struct OrderingResult {
  Ordering used = Ordering::natural;
  std::vector<int> permutation;  // position -> unknown
};

// Fill-reducing ordering, computed on the graph of the groups and expanded to unknowns.
OrderingResult compute_ordering(const SymmetricMatrix& A, Ordering wanted);

// Position -> unknown, with time, count and kind of the ordering entered in the statistics.
std::vector<int> timed_ordering(const SymmetricMatrix& A, Ordering wanted, Statistics& statistics);

// Whether the graph of the groups has the density of a tetrahedral mesh rather than a triangular one.
bool is_of_3d_kind(const SymmetricMatrix& A);

// Lower triangle of the graph of the groups, one unknown per group, values zero.
struct GroupGraph {
  SymmetricMatrix matrix;
  std::vector<int> first;  // group -> first unknown; one more entry than groups
};
GroupGraph group_graph(const SymmetricMatrix& A);

}  // namespace isostretch::sparse

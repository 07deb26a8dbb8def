#pragma once

#include <isostretch/sparse/matrix.hpp>
#include <isostretch/sparse/solver.hpp>

#include <vector>

namespace isostretch::sparse {

// A fill-reducing ordering, computed on the graph of the groups and expanded to unknowns, that serves
// patterns near to the one it was computed for.
//
// For such a pattern, one group of each new pair is moved to the end. The factor of what remains is as it
// was, and the groups moved add a few full rows each; left at its place, a pair that is far apart would
// couple the separators above either, which is the expensive part of a factor.
class KeptOrdering {
 public:
  // Position -> unknown. Those of `last` come last, in their order. Enters time, count and kind in the
  // statistics.
  std::vector<int> compute(const SymmetricMatrix& A, Ordering wanted, const std::vector<int>& last,
                           Statistics& statistics);
  // The same for a pattern of the same groups.
  std::vector<int> adapt(const SymmetricMatrix& A) const;
  // Number of unknowns that come last.
  int last_count() const { return static_cast<int>(last_.size()); }

 private:
  std::vector<int> adapted(const SymmetricMatrix& A) const;

  Ordering used_ = Ordering::natural;
  std::vector<int> column_start_, row_;  // of the graph, sorted
  std::vector<int> groups_;              // position -> group of the graph
  std::vector<int> last_;
};

// Whether the graph of the groups has the density of a tetrahedral mesh rather than a triangular one.
bool is_of_3d_kind(const SymmetricMatrix& A);

// Lower triangle of the graph of the groups, one unknown per group, values zero.
struct GroupGraph {
  SymmetricMatrix matrix;
  std::vector<int> first;  // group -> first unknown; one more entry than groups
};
GroupGraph group_graph(const SymmetricMatrix& A);

}  // namespace isostretch::sparse

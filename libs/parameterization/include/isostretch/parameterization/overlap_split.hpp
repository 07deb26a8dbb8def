#pragma once

#include <isostretch/parameterization/solution.hpp>
#include <isostretch/surface/overlap.hpp>

#include <vector>

namespace isostretch::parameterization {

/// The division of charts that lie on themselves.
struct OverlapSplit {
  bool done = false;  ///< Whether charts were looked at, and divided where needed.
  /// Share of the area of charts that lay under more than one triangle of its chart before.
  double share_before = 0;
  std::size_t charts_added = 0;  ///< Number of charts that were added.
  double cut_length = 0;         ///< Length of the cuts that were added, in units of the model.
};

/// Divides charts until none lies on itself, if the options say so, and returns what was done. Domain, start
/// and solution follow.
OverlapSplit split_overlap(Domain& domain, Start& start, Solution& solution, const Options& options);

/// Returns the charts that have one of the overlapping triangles, ascending.
std::vector<int> charts_concerned(const Domain& domain, const mesh::Overlap& overlap);

}  // namespace isostretch::parameterization

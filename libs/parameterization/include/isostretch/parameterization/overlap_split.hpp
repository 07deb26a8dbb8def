#pragma once

#include <isostretch/parameterization/solution.hpp>
#include <isostretch/surface/overlap.hpp>

#include <vector>

namespace isostretch::parameterization {

/// What was done about charts that lay on themselves.
struct OverlapSplit {
  bool done = false;        ///< charts were looked at, and divided where needed
  double share_before = 0;  ///< of the area of charts, under more than one triangle of its chart
  std::size_t charts_added = 0;
  double cut_length = 0;  ///< added, in units of the model
};

/// Divides charts until none lies on itself, if the options say so. Domain, start and solution follow.
OverlapSplit split_overlap(Domain& domain, Start& start, Solution& solution, const Options& options);

/// Charts that have one of the triangles, ascending.
std::vector<int> charts_concerned(const Domain& domain, const mesh::Overlap& overlap);

}  // namespace isostretch::parameterization

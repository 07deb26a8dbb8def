#pragma once

#include <isostretch/comparison/problem.hpp>
#include <isostretch/newton/summary.hpp>

#include <string>

namespace isostretch::comparison {

/// Returns the text of the summary.json that a run of one method on one problem leaves, which
/// MethodRuns reads: the solve, its phases, flips at `x`, the facts of the problem and the machine.
std::string method_summary(const Problem& problem, const std::string& method, const newton::Summary& summary,
                           const Vector& x, const Record& machine);

}  // namespace isostretch::comparison

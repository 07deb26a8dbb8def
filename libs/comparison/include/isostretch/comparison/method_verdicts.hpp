#pragma once

#include <isostretch/comparison/method_comparison.hpp>

#include <string>
#include <vector>

namespace isostretch::comparison {

/// Returns who is first to each of the chief goals, a sentence each, without the final stop.
std::vector<std::string> verdicts(const ComparedProblem& problem, const scene::ComparisonLimits& limits);

/// Returns "relative error 1e-06", "|gradient|_inf 1e-04".
std::string goal_text(const Goal& goal, const scene::ComparisonLimits& limits);

/// Returns what limits what was found: runs that ended early, minima that differ, an optimum that is not
/// polished.
std::vector<std::string> reservations(const ComparedProblem& problem, const scene::ComparisonLimits& limits);

/// A method that did not converge, with the reason.
struct Shortfall {
  std::string method;   ///< Name of the method.
  std::string status;   ///< Name of its status.
  std::string message;  ///< Reason.
};
/// Returns the methods that did not converge.
std::vector<Shortfall> shortfalls(const ComparedProblem& problem);

}  // namespace isostretch::comparison

#pragma once

#include "comparison.hpp"

#include <string>
#include <vector>

namespace isostretch::app::compare {

// Who is first to each of the chief goals, a sentence each, without the final stop.
std::vector<std::string> verdicts(const ProblemResult& problem, const Limits& limits);

// "relative error 1e-06", "|gradient|_inf 1e-04".
std::string goal_text(const Goal& goal, const Limits& limits);

// What limits what was found: runs that ended early, minima that differ, an optimum that is not polished.
std::vector<std::string> reservations(const ProblemResult& problem, const Limits& limits);

// Methods that did not converge, with the reason.
struct Shortfall {
  std::string method, status, message;
};
std::vector<Shortfall> shortfalls(const ProblemResult& problem);

}  // namespace isostretch::app::compare

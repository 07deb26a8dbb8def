#pragma once

#include <isostretch/comparison/method_comparison.hpp>
#include <isostretch/comparison/method_runs.hpp>

#include <functional>

namespace isostretch::comparison {

/// Sets the optimum of a problem: the least energy that any run has seen, or that the default method reaches
/// from the best end, by a run of its own. From ends of methods that converged clearly above it the default
/// goes on, too; where it stays there, that is another minimum. `begin` is called before the first of these
/// runs. A request of `runs.stop` ends it with what is known by then.
void find_optimum(ComparedProblem& problem, const MethodRuns& runs, const std::function<void()>& begin);

}  // namespace isostretch::comparison

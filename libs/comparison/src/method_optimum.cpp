#include <isostretch/comparison/method_optimum.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::comparison {
namespace {

std::pair<const MethodCandidate*, const MethodRun*> best_end(const ComparedProblem& problem) {
  std::pair<const MethodCandidate*, const MethodRun*> best{nullptr, nullptr};
  for (const MethodCandidate& candidate : problem.candidates)
    for (const MethodRun& run : candidate.runs)
      if (std::isfinite(run.energy()) && (best.second == nullptr || run.energy() < best.second->energy()))
        best = {&candidate, &run};
  return best;
}

void take_least(ComparedProblem& problem, const MethodRun& run, const std::string& whose) {
  std::vector<double> energies{run.energy()};
  for (const MethodTraceRow& row : run.trace) energies.push_back(row.energy);
  for (const double energy : energies) {
    if (!std::isfinite(energy) || energy >= problem.optimum) continue;
    problem.optimum = energy;
    problem.optimum_of = whose;
    problem.optimum_folder = run.folder;
  }
}

// Whether that went on until nothing improved any more.
bool polish(ComparedProblem& problem, const MethodRuns& runs, const MethodCandidate& candidate,
            const MethodRun& run) {
  const std::string method(candidate.info.name);
  const MethodRun end = runs.polished(problem, method, run);
  take_least(problem, end, default_method() + " from the end of " + method);
  const bool at_the_end = end.has_summary() && end.converged;
  if (at_the_end) problem.elsewhere.push_back({method, end.energy()});
  return at_the_end;
}

// A method that says it converged, far above the best, may only have stopped early: polishing tells.
void look_elsewhere(ComparedProblem& problem, const MethodRuns& runs, const MethodCandidate& candidate) {
  const auto run = std::find_if(candidate.runs.begin(), candidate.runs.end(),
                                [](const MethodRun& r) { return r.converged; });
  if (run != candidate.runs.end() && problem.relative_error(run->energy()) > same_minimum)
    polish(problem, runs, candidate, *run);
}

}  // namespace

void find_optimum(ComparedProblem& problem, const MethodRuns& runs, const std::function<void()>& begin) {
  for (const MethodCandidate& candidate : problem.candidates)
    for (const MethodRun& run : candidate.runs) take_least(problem, run, std::string(candidate.info.name));
  const auto [best_candidate, best_run] = best_end(problem);
  if (best_run == nullptr || runs.stop.stop_requested()) return;
  begin();
  problem.polished = polish(problem, runs, *best_candidate, *best_run);
  for (const MethodCandidate& candidate : problem.candidates)
    if (!runs.stop.stop_requested() && &candidate != best_candidate) look_elsewhere(problem, runs, candidate);
  std::erase_if(problem.elsewhere, [&](const OtherMinimum& minimum) {
    return !(problem.relative_error(minimum.energy) > same_minimum);
  });
}

}  // namespace isostretch::comparison

#include <isostretch/comparison/method_verdicts.hpp>
#include <isostretch/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace isostretch::comparison {
namespace {

constexpr double least_chief_error = 1e-9;

std::string seconds_text(double seconds) {
  return formatted("%.3g s", seconds);
}

// Where the default is first.
std::string lead(const GoalBenchmark& benchmark) {
  std::string text = benchmark.first + " is first, after " + seconds_text(benchmark.first_seconds);
  if (benchmark.best_rival.empty()) return text + "; no rival gets there";
  return text + "; the best rival, " + benchmark.best_rival + ", takes " +
         seconds_text(benchmark.rival_seconds) + formatted(", %.2f times as long", benchmark.rival_factor());
}

bool ends_elsewhere(const ComparedProblem& problem, std::string_view method) {
  return std::any_of(problem.elsewhere.begin(), problem.elsewhere.end(),
                     [&](const OtherMinimum& other) { return other.method == method; });
}

std::string why_not_there(const ComparedProblem& problem) {
  const std::string name = default_method();
  const auto candidate = std::find_if(problem.candidates.begin(), problem.candidates.end(),
                                      [&](const MethodCandidate& e) { return e.info.name == name; });
  if (candidate == problem.candidates.end() || candidate->runs.empty()) return name + " was not run";
  if (!candidate->has_converged()) return name + " does not: " + candidate->status();
  return name +
         (ends_elsewhere(problem, name) ? " ends at another minimum" : " ended at its tolerance before");
}

std::string lag(const ComparedProblem& problem, const GoalBenchmark& benchmark) {
  const std::string text =
      benchmark.first + " is first, after " + seconds_text(benchmark.first_seconds) + "; ";
  if (std::isinf(benchmark.default_seconds)) return text + why_not_there(problem);
  return text + default_method() + " takes " + seconds_text(benchmark.default_seconds) +
         formatted(", %.2f times as long", benchmark.factor());
}

std::string verdict(const ComparedProblem& problem, const GoalBenchmark& benchmark,
                    const scene::ComparisonLimits& limits) {
  const std::string goal = goal_text(benchmark.goal, limits) + ": ";
  if (benchmark.first.empty()) return goal + "nobody gets there; " + why_not_there(problem);
  return goal + (benchmark.default_is_first() ? lead(benchmark) : lag(problem, benchmark));
}

int ended_early(const ComparedProblem& problem) {
  return static_cast<int>(std::count_if(
      problem.candidates.begin(), problem.candidates.end(), [&](const MethodCandidate& candidate) {
        return candidate.has_converged() && !ends_elsewhere(problem, candidate.info.name) &&
               problem.relative_error(candidate.typical()->energy()) > least_chief_error;
      }));
}

std::string other_minima(const ComparedProblem& problem) {
  std::string text;
  for (const OtherMinimum& other : problem.elsewhere)
    text += (text.empty() ? "" : "; ") + other.method +
            formatted(" %.10g (%.2g)", other.energy, problem.relative_error(other.energy));
  return "methods end at different minima, and their errors are those of the minimum: with the share above "
         "the least in brackets, " +
         text;
}

}  // namespace

std::string goal_text(const Goal& goal, const scene::ComparisonLimits& limits) {
  return goal.error ? "relative error " + goal.name()
                    : formatted("|gradient|_inf %.0e", limits.gradient_tolerance);
}

std::vector<std::string> verdicts(const ComparedProblem& problem, const scene::ComparisonLimits& limits) {
  std::vector<std::string> lines;
  for (const Goal& goal : chief_goals(limits))
    lines.push_back(verdict(problem, benchmark_goal(goal, problem, limits), limits));
  return lines;
}

std::vector<std::string> reservations(const ComparedProblem& problem, const scene::ComparisonLimits& limits) {
  std::vector<std::string> lines;
  if (const int count = ended_early(problem); count > 0)
    lines.push_back(
        formatted("%d method(s) ended at |gradient|_inf <= %g, or where they found nothing better, with a "
                  "relative error above %.0e; a smaller gradient tolerance may let them go on",
                  count, limits.gradient_tolerance, least_chief_error));
  if (std::isnan(problem.optimum)) lines.emplace_back("no method left an energy: errors are unknown");
  if (!std::isnan(problem.optimum) && !problem.polished)
    lines.emplace_back("the optimum is the least energy seen, not polished until round-off");
  if (!problem.elsewhere.empty()) lines.push_back(other_minima(problem));
  return lines;
}

std::vector<Shortfall> shortfalls(const ComparedProblem& problem) {
  std::vector<Shortfall> all;
  for (const MethodCandidate& candidate : problem.candidates)
    if (const MethodRun* run = candidate.typical(); run != nullptr && !run->converged)
      all.push_back({std::string(candidate.info.name), run->status, run->message});
  return all;
}

}  // namespace isostretch::comparison

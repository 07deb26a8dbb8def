#include "json.hpp"

#include <isostretch/comparison/method_comparison.hpp>
#include <isostretch/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::comparison {
namespace {

bool is_reached(const Goal& goal, const ComparedProblem& problem, const MethodTraceRow& row,
                const scene::ComparisonLimits& limits) {
  return goal.error ? problem.relative_error(row.energy) <= *goal.error
                    : row.gradient <= limits.gradient_tolerance;
}

// Of the runs for which the quantity is a number, infinity included.
template <class Quantity>
Spread spread(const MethodCandidate& candidate, const Quantity& quantity) {
  std::vector<std::pair<double, int>> values;
  for (const MethodRun& run : candidate.runs)
    if (const double value = quantity(run); !std::isnan(value)) values.emplace_back(value, run.repetition);
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto& [median, repetition] = values[(values.size() - 1) / 2];
  return {median, values.front().first, values.back().first, repetition};
}

std::vector<Goal> goals(const std::vector<double>& errors, const scene::ComparisonLimits& limits) {
  std::vector<Goal> all;
  for (const double error : errors) all.push_back({error});
  if (limits.gradient_tolerance > 0) all.push_back({});
  return all;
}

}  // namespace

std::string MethodCandidate::status() const {
  const MethodRun* run = typical();
  return run != nullptr ? run->status : "not_run";
}

const MethodRun* MethodCandidate::typical() const {
  const auto count = [&](const MethodRun& run) {
    return std::count_if(runs.begin(), runs.end(),
                         [&](const MethodRun& r) { return r.status == run.status; });
  };
  const auto found = std::max_element(
      runs.begin(), runs.end(), [&](const MethodRun& a, const MethodRun& b) { return count(a) < count(b); });
  return found == runs.end() ? nullptr : &*found;
}

bool MethodCandidate::has_converged() const {
  const MethodRun* run = typical();
  return run != nullptr && run->converged;
}

const MethodRun* MethodCandidate::median_run() const {
  const int repetition = total_seconds(*this).repetition;
  const auto found = std::find_if(runs.begin(), runs.end(),
                                  [&](const MethodRun& run) { return run.repetition == repetition; });
  return found == runs.end() ? nullptr : &*found;
}

double ComparedProblem::relative_error(double energy) const {
  constexpr double rounding = 1e-15;  // energies are sums over a rest of volume 1 of numbers around 1
  return (energy - optimum) / std::max(std::abs(optimum), rounding);
}

std::string default_method() {
  return std::string(baselines::methods().front().name);
}

std::string Goal::name() const {
  return error ? formatted("%.0e", *error) : "gradient";
}

std::vector<Goal> all_goals(const scene::ComparisonLimits& limits) {
  return goals({1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}, limits);
}

std::vector<Goal> chief_goals(const scene::ComparisonLimits& limits) {
  return goals({1e-3, 1e-6, 1e-9}, limits);
}

double seconds_to(const Goal& goal, const ComparedProblem& problem, const MethodRun& run,
                  const scene::ComparisonLimits& limits) {
  double seconds = never;
  for (auto row = run.trace.rbegin(); row != run.trace.rend(); ++row) {
    if (!is_reached(goal, problem, *row, limits)) break;
    seconds = row->seconds;
  }
  return seconds;
}

Spread time_to(const Goal& goal, const ComparedProblem& problem, const MethodCandidate& candidate,
               const scene::ComparisonLimits& limits) {
  return spread(candidate, [&](const MethodRun& run) { return seconds_to(goal, problem, run, limits); });
}

Spread total_seconds(const MethodCandidate& candidate) {
  return spread(candidate, [](const MethodRun& run) { return run.seconds; });
}

Spread peak_megabytes(const MethodCandidate& candidate) {
  return spread(candidate,
                [](const MethodRun& run) { return run.peak_megabytes > 0 ? run.peak_megabytes : unknown; });
}

IterationPhases milliseconds_per_iteration(const MethodCandidate& candidate) {
  const MethodRun* run = candidate.median_run();
  if (run == nullptr || !run->has_summary()) return {};
  const double iterations = run->summary.number("iterations");
  if (!(iterations > 0)) return {};
  const Record seconds = run->summary.at("seconds");
  const auto per_iteration = [&](const char* phase) { return 1e3 * seconds.number(phase) / iterations; };
  IterationPhases times{per_iteration("assembly"), per_iteration("factorization"), per_iteration("solve"),
                        per_iteration("line_search")};
  times.total = per_iteration("minimize");
  times.other =
      std::max(0.0, times.total - times.assembly - times.factorization - times.solve - times.line_search);
  return times;
}

GoalBenchmark benchmark_goal(const Goal& goal, const ComparedProblem& problem,
                             const scene::ComparisonLimits& limits) {
  GoalBenchmark result;
  result.goal = goal;
  for (const MethodCandidate& candidate : problem.candidates) {
    const double seconds = time_to(goal, problem, candidate, limits).median;
    const std::string name(candidate.info.name);
    if (name == default_method() && !std::isnan(seconds)) result.default_seconds = seconds;
    if (seconds < result.first_seconds) result.first_seconds = seconds, result.first = name;
    if (candidate.is_rival() && seconds < result.rival_seconds)
      result.rival_seconds = seconds, result.best_rival = name;
  }
  return result;
}

int MethodComparison::wanted_runs() const {
  int count = 0;
  for (const ComparedProblem& problem : problems)
    for (const MethodCandidate& candidate : problem.candidates)
      count += candidate.why_not_applicable.empty() ? 1 : 0;
  return count * settings.repetitions;
}

int MethodComparison::made_runs() const {
  std::size_t count = 0;
  for (const ComparedProblem& problem : problems)
    for (const MethodCandidate& candidate : problem.candidates) count += candidate.runs.size();
  return static_cast<int>(count);
}

ComparedProblem compared_problem(const Problem& problem, const scene::Value& scene_value,
                                 const std::vector<std::string>& methods) {
  ComparedProblem result;
  result.name = problem.name;
  result.facts = problem.facts;
  for (const baselines::MethodInfo& info : baselines::methods())
    if (std::find(methods.begin(), methods.end(), info.name) != methods.end())
      result.candidates.push_back({info, baselines::why_not_applicable(info.name, problem.distortion), {}});
  // Where a file lies does not matter; what is in it does.
  scene::Value without_mesh = scene_value;
  without_mesh.take("mesh");
  result.identity = problem.facts.text("fingerprint") + '\n' + scene::to_json(without_mesh);
  return result;
}

std::vector<Profile> performance_profiles(const MethodComparison& comparison) {
  std::vector<Profile> profiles;
  for (const Goal& goal : chief_goals(comparison.settings.limits)) {
    Profile profile{goal, {}};
    for (const std::string& name : comparison.settings.methods) profile.curves.push_back({name, {}});
    for (const ComparedProblem& problem : comparison.problems) {
      const double first = benchmark_goal(goal, problem, comparison.settings.limits).first_seconds;
      for (std::size_t m = 0; m < profile.curves.size(); ++m) {
        const double seconds =
            time_to(goal, problem, problem.candidates[m], comparison.settings.limits).median;
        profile.curves[m].factors.push_back(std::isfinite(seconds) ? seconds / first : never);
      }
    }
    profiles.push_back(std::move(profile));
  }
  return profiles;
}

}  // namespace isostretch::comparison

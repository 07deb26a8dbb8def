#include "comparison.hpp"

#include <isostretch/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::app::compare {
namespace {

double number(const Json& object, const char* key) {
  if (!object.is_object() || !object.contains(key) || !object.at(key).is_number()) return unknown;
  return object.at(key).get<double>();
}

bool is_reached(const Goal& goal, const ProblemResult& problem, const TraceRow& row, const Limits& limits) {
  return goal.error ? problem.relative_error(row.energy) <= *goal.error
                    : row.gradient <= limits.gradient_tolerance;
}

// Of the runs for which the quantity is a number, infinity included.
template <class Quantity>
Spread spread(const Entry& entry, const Quantity& quantity) {
  std::vector<std::pair<double, int>> values;
  for (const Run& run : entry.runs)
    if (const double value = quantity(run); !std::isnan(value)) values.emplace_back(value, run.repetition);
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto& [median, repetition] = values[(values.size() - 1) / 2];
  return {median, values.front().first, values.back().first, repetition};
}

std::vector<Goal> goals(const std::vector<double>& errors, const Limits& limits) {
  std::vector<Goal> all;
  for (const double error : errors) all.push_back({error});
  if (limits.gradient_tolerance > 0) all.push_back({});
  return all;
}

}  // namespace

double Run::energy() const {
  return number(summary, "energy");
}

std::string Entry::status() const {
  const Run* run = typical();
  return run != nullptr ? run->status : "not_run";
}

const Run* Entry::typical() const {
  const auto count = [&](const Run& run) {
    return std::count_if(runs.begin(), runs.end(), [&](const Run& r) { return r.status == run.status; });
  };
  const auto found = std::max_element(runs.begin(), runs.end(),
                                      [&](const Run& a, const Run& b) { return count(a) < count(b); });
  return found == runs.end() ? nullptr : &*found;
}

bool Entry::has_converged() const {
  const Run* run = typical();
  return run != nullptr && run->converged;
}

const Run* Entry::median_run() const {
  const int repetition = total_seconds(*this).repetition;
  const auto found =
      std::find_if(runs.begin(), runs.end(), [&](const Run& run) { return run.repetition == repetition; });
  return found == runs.end() ? nullptr : &*found;
}

double ProblemResult::relative_error(double energy) const {
  constexpr double rounding = 1e-15;  // energies are sums over a rest of volume 1 of numbers around 1
  return (energy - optimum) / std::max(std::abs(optimum), rounding);
}

std::string default_method() {
  return std::string(baselines::methods().front().name);
}

std::string Goal::name() const {
  return error ? formatted("%.0e", *error) : "gradient";
}

std::vector<Goal> all_goals(const Limits& limits) {
  return goals({1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}, limits);
}

std::vector<Goal> chief_goals(const Limits& limits) {
  return goals({1e-3, 1e-6, 1e-9}, limits);
}

double seconds_to(const Goal& goal, const ProblemResult& problem, const Run& run, const Limits& limits) {
  double seconds = never;
  for (auto row = run.trace.rbegin(); row != run.trace.rend(); ++row) {
    if (!is_reached(goal, problem, *row, limits)) break;
    seconds = row->seconds;
  }
  return seconds;
}

Spread time_to(const Goal& goal, const ProblemResult& problem, const Entry& entry, const Limits& limits) {
  return spread(entry, [&](const Run& run) { return seconds_to(goal, problem, run, limits); });
}

Spread total_seconds(const Entry& entry) {
  return spread(entry, [](const Run& run) { return run.seconds; });
}

Spread peak_megabytes(const Entry& entry) {
  return spread(entry, [](const Run& run) { return run.peak_megabytes > 0 ? run.peak_megabytes : unknown; });
}

PhaseTimes milliseconds_per_iteration(const Entry& entry) {
  const Run* run = entry.median_run();
  if (run == nullptr || !run->has_summary()) return {};
  const double iterations = number(run->summary, "iterations");
  if (!(iterations > 0)) return {};
  const auto per_iteration = [&](const char* phase) {
    return 1e3 * number(run->summary.at("seconds"), phase) / iterations;
  };
  PhaseTimes times{per_iteration("assembly"), per_iteration("factorization"), per_iteration("solve"),
                   per_iteration("line_search")};
  times.total = per_iteration("minimize");
  times.other =
      std::max(0.0, times.total - times.assembly - times.factorization - times.solve - times.line_search);
  return times;
}

GoalBenchmark benchmark_goal(const Goal& goal, const ProblemResult& problem, const Limits& limits) {
  GoalBenchmark result;
  result.goal = goal;
  for (const Entry& entry : problem.entries) {
    const double seconds = time_to(goal, problem, entry, limits).median;
    const std::string name(entry.info.name);
    if (name == default_method() && !std::isnan(seconds)) result.default_seconds = seconds;
    if (seconds < result.first_seconds) result.first_seconds = seconds, result.first = name;
    if (entry.is_rival() && seconds < result.rival_seconds)
      result.rival_seconds = seconds, result.best_rival = name;
  }
  return result;
}

std::vector<Profile> performance_profiles(const Comparison& comparison) {
  std::vector<Profile> profiles;
  for (const Goal& goal : chief_goals(comparison.options.limits)) {
    Profile profile{goal, {}};
    for (const std::string& name : comparison.options.methods) profile.curves.push_back({name, {}});
    for (const ProblemResult& problem : comparison.problems) {
      const double first = benchmark_goal(goal, problem, comparison.options.limits).first_seconds;
      for (std::size_t m = 0; m < profile.curves.size(); ++m) {
        const double seconds = time_to(goal, problem, problem.entries[m], comparison.options.limits).median;
        profile.curves[m].factors.push_back(std::isfinite(seconds) ? seconds / first : never);
      }
    }
    profiles.push_back(std::move(profile));
  }
  return profiles;
}

}  // namespace isostretch::app::compare

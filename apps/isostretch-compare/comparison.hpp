#pragma once

#include "common/output_folder.hpp"
#include "options.hpp"

#include <isostretch/baselines/distortion.hpp>

#include <nlohmann/json.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::app::compare {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double never = std::numeric_limits<double>::infinity();

// One row of a trace.csv.
struct TraceRow {
  double iteration = 0, seconds = 0, energy = 0, gradient = 0;
};

// What came of one run, as its own process reported it.
struct Run {
  int repetition = 1;
  std::string folder;  // within the output folder
  std::string status = "not_run", message;
  bool converged = false;
  Json summary;  // null where it left none
  std::vector<TraceRow> trace;
  double seconds = unknown;  // of the minimisation; of its process where it left no account
  double peak_megabytes = 0;

  bool has_summary() const { return summary.is_object(); }
  double energy() const;  // at the end; NaN where it is not known
};

// One method on one problem.
struct Entry {
  baselines::MethodInfo info;
  std::string why_not_applicable;  // why it was not run; empty where it was
  std::vector<Run> runs;           // repetition by repetition

  std::string status() const;  // of most runs
  // A run of that status.
  const Run* typical() const;
  bool has_converged() const;
  // The run that has the median of the seconds, and stands for all in plots.
  const Run* median_run() const;
  bool is_rival() const { return info.family != baselines::Family::own; }
};

// Where the default ends that goes on from the end of a method.
struct OtherMinimum {
  std::string method;
  double energy = 0;
};

struct ProblemResult {
  std::string name;
  Json facts;
  std::vector<Entry> entries;
  double optimum = unknown;             // the least energy anybody has seen
  std::string optimum_of;               // who has seen it
  std::string optimum_folder;           // in which run
  bool polished = false;                // the default went on from the best run until round-off
  std::vector<OtherMinimum> elsewhere;  // clearly above the optimum

  // (E - optimum) / |optimum|.
  double relative_error(double energy) const;
};

struct Comparison {
  Options options;
  std::string date;
  Json machine;
  std::vector<ProblemResult> problems;
};

// The method that the others are held against: ours as it comes.
std::string default_method();

// Above this the minima of two methods are different ones.
constexpr double same_minimum = 1e-6;

// Something to reach: a relative error of the energy, or the gradient tolerance where there is none.
struct Goal {
  std::optional<double> error;
  std::string name() const;  // "1e-03", "gradient"
};
// Without a gradient tolerance there is no such goal.
std::vector<Goal> all_goals(const Limits& limits);
// Those that the report's verdicts are about.
std::vector<Goal> chief_goals(const Limits& limits);

// Seconds at the first row of the trace from which on the goal stays reached.
double seconds_to(const Goal& goal, const ProblemResult& problem, const Run& run, const Limits& limits);

// A quantity over the repetitions. The median is that of a run, the lower of two.
struct Spread {
  double median = unknown, least = unknown, most = unknown;
  int repetition = 0;  // that has the median; 0: there is none
};

// Of the time to a goal; infinite where it is not reached.
Spread time_to(const Goal& goal, const ProblemResult& problem, const Entry& entry, const Limits& limits);
Spread total_seconds(const Entry& entry);
Spread peak_megabytes(const Entry& entry);

// Of the run with the median of the seconds: milliseconds per iteration by phase.
struct PhaseTimes {
  double assembly = unknown, factorization = unknown, solve = unknown, line_search = unknown, other = unknown;
  double total = unknown;
};
PhaseTimes milliseconds_per_iteration(const Entry& entry);

// Who reaches a goal first, by the medians.
struct GoalBenchmark {
  Goal goal;
  std::string first;  // empty where nobody does
  double first_seconds = never, default_seconds = never;
  std::string best_rival;  // of no method of ours; empty where none does
  double rival_seconds = never;

  bool default_is_first() const { return first == default_method(); }
  // Of the default behind the first, and of the rival behind the default; not finite where one of them
  // does not get there.
  double factor() const { return default_seconds / first_seconds; }
  double rival_factor() const { return default_seconds < never ? rival_seconds / default_seconds : unknown; }
};
GoalBenchmark benchmark_goal(const Goal& goal, const ProblemResult& problem, const Limits& limits);

// Dolan & More 2002: for every method the factor by which it is behind the first, problem by problem.
struct Profile {
  struct Curve {
    std::string method;
    std::vector<double> factors;  // one a problem; infinite where it does not reach the goal
  };
  Goal goal;
  std::vector<Curve> curves;
};
std::vector<Profile> performance_profiles(const Comparison& comparison);

}  // namespace isostretch::app::compare

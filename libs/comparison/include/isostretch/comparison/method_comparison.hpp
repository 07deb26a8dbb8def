#pragma once

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/comparison/method_scene.hpp>
#include <isostretch/comparison/problem.hpp>
#include <isostretch/comparison/record.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::comparison {

/// A number that nobody knows, NaN.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
/// The seconds until what is not reached, infinity.
constexpr double never = std::numeric_limits<double>::infinity();

/// One row of the trace.csv of a method.
struct MethodTraceRow {
  double iteration = 0;  ///< Number of the iteration.
  double seconds = 0;    ///< Seconds since the start.
  double energy = 0;     ///< Energy.
  double gradient = 0;   ///< Largest component of the gradient.
};

/// One run of a method, as its own process reported it.
struct MethodRun {
  int repetition = 1;                 ///< Number of the repetition.
  std::string folder;                 ///< within the output folder
  std::string status = "not_run";     ///< Name of the status.
  std::string message;                ///< Message that goes with it.
  bool converged = false;             ///< Whether it converged.
  Record summary;                     ///< null where it left none
  std::vector<MethodTraceRow> trace;  ///< Its course.
  double seconds = unknown;   ///< Seconds of the minimisation; of its process where it left no account.
  double peak_megabytes = 0;  ///< Most memory that it took.

  /// Returns whether it left an account of itself.
  bool has_summary() const { return summary.is_object(); }
  /// Returns the energy at its end; NaN where it is not known.
  double energy() const { return summary.number("energy"); }
};

/// One method on one problem, with all of its runs.
struct MethodCandidate {
  baselines::MethodInfo info;      ///< The method.
  std::string why_not_applicable;  ///< why it was not run; empty where it was
  std::vector<MethodRun> runs;     ///< repetition by repetition

  /// Returns the status of most runs.
  std::string status() const;
  /// Returns a run of that status; none where there are no runs.
  const MethodRun* typical() const;
  /// Returns whether that run converged.
  bool has_converged() const;
  /// Returns the run that has the median of the seconds, and stands for all in plots.
  const MethodRun* median_run() const;
  /// Returns whether it is no method of this project.
  bool is_rival() const { return info.family != baselines::Family::own; }
};

/// Where the default ends that goes on from the end of a method.
struct OtherMinimum {
  std::string method;  ///< Name of the method.
  double energy = 0;   ///< Energy there.
};

/// A problem with what all methods made of it.
struct ComparedProblem {
  std::string name;                         ///< Name of the problem.
  Record facts;                             ///< see Problem
  std::string identity;                     ///< All that runs depend on besides program and arguments.
  std::vector<MethodCandidate> candidates;  ///< All methods, those that do not apply too.
  double optimum = unknown;                 ///< the least energy anybody has seen
  std::string optimum_of;                   ///< who has seen it
  std::string optimum_folder;               ///< in which run
  bool polished = false;                    ///< the default went on from the best run until round-off
  std::vector<OtherMinimum> elsewhere;      ///< clearly above the optimum

  /// Returns (E - optimum) / |optimum|.
  double relative_error(double energy) const;
};

/// Methods on problems.
struct MethodComparison {
  ComparisonSettings settings;  ///< Methods, limits and repetitions.
  std::string date;             ///< Date of the comparison.
  /// All that times depend on besides the program: processor, cores, memory_megabytes, system, threads,
  /// environment, version, instruction_set, compiler, flags.
  Record machine;
  std::vector<ComparedProblem> problems;  ///< The problems.

  /// Returns the number of runs that are to be made.
  int wanted_runs() const;
  /// Returns the number of runs that there are.
  int made_runs() const;
};

/// Returns a problem as it is before any run: a candidate for each of the methods that are compared, with why
/// it cannot be run where it does not apply. `scene_value`: the problem in its scene.
ComparedProblem compared_problem(const Problem& problem, const scene::Value& scene_value,
                                 const std::vector<std::string>& methods);

/// Returns the method that the others are held against: ours as it comes.
std::string default_method();

/// Above this relative error the minima of two methods are different ones.
constexpr double same_minimum = 1e-6;

/// Something to reach: a relative error of the energy, or the gradient tolerance where there is none.
struct Goal {
  std::optional<double> error;  ///< Relative error of the energy; none: the gradient tolerance.
  /// Returns "1e-03", or "gradient".
  std::string name() const;
};
/// Returns all goals of tables. Without a gradient tolerance there is no such goal.
std::vector<Goal> all_goals(const scene::ComparisonLimits& limits);
/// Returns those goals that the report's verdicts are about.
std::vector<Goal> chief_goals(const scene::ComparisonLimits& limits);

/// Returns the seconds at the first row of the trace from which on the goal stays reached.
double seconds_to(const Goal& goal, const ComparedProblem& problem, const MethodRun& run,
                  const scene::ComparisonLimits& limits);

/// A quantity over the repetitions. The median is that of a run, the lower of two.
struct Spread {
  double median = unknown;  ///< Median.
  double least = unknown;   ///< Least.
  double most = unknown;    ///< Most.
  int repetition = 0;       ///< that has the median; 0: there is none
};

/// Returns the spread of the time to a goal; infinite where it is not reached.
Spread time_to(const Goal& goal, const ComparedProblem& problem, const MethodCandidate& candidate,
               const scene::ComparisonLimits& limits);
/// Returns the spread of the seconds of runs.
Spread total_seconds(const MethodCandidate& candidate);
/// Returns the spread of the most memory that runs took.
Spread peak_megabytes(const MethodCandidate& candidate);

/// Milliseconds per iteration by phase.
struct IterationPhases {
  double assembly = unknown;       ///< Gradient and Hessian.
  double factorization = unknown;  ///< Factorization.
  double solve = unknown;          ///< Solves with the factor.
  double line_search = unknown;    ///< Line search.
  double other = unknown;          ///< Set-up and all else.
  double total = unknown;          ///< All of it.
};
/// Returns the phases of the run with the median of the seconds.
IterationPhases milliseconds_per_iteration(const MethodCandidate& candidate);

/// Who reaches a goal first, by the medians.
struct GoalBenchmark {
  Goal goal;                       ///< The goal.
  std::string first;               ///< empty where nobody does
  double first_seconds = never;    ///< Seconds of the first.
  double default_seconds = never;  ///< Seconds of the default.
  std::string best_rival;          ///< The first method that is not ours; empty where none gets there.
  double rival_seconds = never;    ///< Seconds of that method.

  /// Returns whether nobody reaches the goal before the default.
  bool default_is_first() const { return first == default_method(); }
  /// Returns how many times as long as the first the default takes; not finite where one does not get there.
  double factor() const { return default_seconds / first_seconds; }
  /// Returns how many times as long as the default the best rival takes; not finite where one does not get
  /// there.
  double rival_factor() const { return default_seconds < never ? rival_seconds / default_seconds : unknown; }
};
/// Returns who reaches the goal first.
GoalBenchmark benchmark_goal(const Goal& goal, const ComparedProblem& problem,
                             const scene::ComparisonLimits& limits);

/// A performance profile (Dolan & More 2002): for every method the factor by which it is behind the first,
/// problem by problem.
struct Profile {
  /// The factors of a method.
  struct Curve {
    std::string method;           ///< Name of the method.
    std::vector<double> factors;  ///< one a problem; infinite where it does not reach the goal
  };
  Goal goal;                  ///< The goal.
  std::vector<Curve> curves;  ///< One of every method.
};
/// Returns the profiles of the goals that verdicts are about.
std::vector<Profile> performance_profiles(const MethodComparison& comparison);

}  // namespace isostretch::comparison

#pragma once

#include <isostretch/baselines/solver.hpp>
#include <isostretch/comparison/record.hpp>

#include <limits>
#include <string>
#include <vector>

namespace isostretch::comparison {

/// One row of a trace.csv of a solver of the inversion-free problem.
struct SolverTraceRow {
  int iteration = 0;           ///< Number of the iteration.
  double seconds = 0;          ///< Seconds since the start.
  double energy = 0;           ///< Energy of the convex problem.
  double min_eigenvalue = 0;   ///< Least eigenvalue of S.
  double min_determinant = 0;  ///< Least det F.
  int inverted = 0;            ///< Elements with det F <= 0.
};

/// One solver with what it made of the instance, as its own process reported it.
struct SolverCandidate {
  baselines::SolverInfo info;         ///< The solver.
  std::string status;                 ///< Name of its status.
  std::string message;                ///< Message that goes with it.
  Record frame;                       ///< The frame in its summary.json; null where it left none.
  std::vector<SolverTraceRow> trace;  ///< Its course.
  double peak_megabytes = 0;          ///< Most memory that its process took.
  /// Modelling, solving and reading; of its process where it left no account; NaN where it was not run.
  double seconds = std::numeric_limits<double>::quiet_NaN();
  double least_seconds = 0;  ///< Least seconds of the repetitions.
  double most_seconds = 0;   ///< Most seconds of the repetitions.

  /// Returns whether it left positions.
  bool has_positions() const { return frame.is_object() && !frame.text("file").empty(); }
  /// Returns whether it solves the convex problem, and no alternative formulation.
  bool is_convex() const { return info.kind == baselines::Kind::convex; }
};

/// The mesh of an instance.
struct ComparedMesh {
  std::string name;         ///< Name.
  int nodes = 0;            ///< Number of nodes.
  int elements = 0;         ///< Number of elements.
  std::string fingerprint;  ///< Hash of all that is in it.
};

/// Solvers on one instance of the inversion-free problem.
struct SolverComparison {
  std::string name;   ///< Name of the scene.
  ComparedMesh mesh;  ///< The mesh.
  /// The least energy of the convex problem; NaN where it is not known.
  double optimum = std::numeric_limits<double>::quiet_NaN();
  /// A bound below which no energy of the convex problem lies; NaN where none is known.
  double lower_bound = std::numeric_limits<double>::quiet_NaN();
  std::vector<SolverCandidate> candidates;  ///< The solvers.
  int repetitions = 1;                      ///< Runs of each solver.
  double time_limit = 0;                    ///< seconds; 0: none
  double memory_limit = 0;                  ///< megabytes; 0: none
  int threads = 0;                          ///< Threads of each run.
};

/// Returns |E - optimum| / optimum, of the energy of the convex problem.
double relative_error(const SolverComparison& comparison, double energy);

/// Returns the solvers of these names: "all", "convex", "alternative" or names of solvers, separated by
/// commas; each once. Throws Error listing those there are.
std::vector<baselines::SolverInfo> choose_solvers(const std::string& names);

/// Returns of the repetitions of one solver the run that has the median of the seconds, among those with the
/// most frequent status: times of a run that crashed say nothing about those that did not. There must be one.
SolverCandidate median_candidate(std::vector<SolverCandidate> repetitions);

/// Takes optimum and bound from a run that was to find them. Returns what a user should know: why they are
/// not known, or how well; empty where there is nothing to say. A relative gap of 1e-8, or of `gap` if that
/// is more, counts as known.
std::string take_optimum(SolverComparison& comparison, const SolverCandidate& run, double gap);

/// Returns in one line what a solver has made of the instance.
std::string outcome_text(const SolverComparison& comparison, const SolverCandidate& candidate);

/// Returns the table as CSV, a row a solver.
std::string solver_table(const SolverComparison& comparison);
/// Returns all of it but the traces as the text of comparison.json.
std::string comparison_json(const SolverComparison& comparison);
/// Returns the plots as PNG.
std::string draw_comparison(const SolverComparison& comparison);
/// Returns a page with table and plots.
std::string comparison_page(const SolverComparison& comparison, const std::string& plots);

}  // namespace isostretch::comparison

#pragma once

#include <isostretch/comparison/solver_comparison.hpp>
#include <isostretch/comparison/solver_runs.hpp>
#include <isostretch/core/monitor.hpp>
#include <isostretch/core/output_folder.hpp>
#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/scene/value.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::comparison {

/// The choices of a comparison of solvers.
struct SolverBenchmarkOptions {
  std::string solvers;                       ///< Which solvers, see choose_solvers().
  std::filesystem::path out;                 ///< Folder for results and runs.
  std::filesystem::path weights_cache = {};  ///< Folder of handle weights; empty: one in `out`.
  int repetitions = 1;                       ///< Runs of each solver.
  int refine = 1;                            ///< Factor of the cells of a generated body.
  int frame = 1;                             ///< The frame that is compared on.
  double gap = 0;                            ///< Relative gap that is asked for.
  int threads = 0;                           ///< Threads of each run; 0: as the program likes.
  int thread_count = 1;                      ///< Number of these threads, for the reports.
  double time_limit = 0;                     ///< Seconds of each run; 0: no limit.
  double memory_limit = 0;                   ///< Megabytes of each run; 0: no limit.
  bool picture = true;                       ///< Whether plots and a page are written.
};

/// Many solvers on one frame of a scene, each in a process of its own. A benchmark that was interrupted goes
/// on where it was when it is run again.
class SolverBenchmark {
 public:
  /// Prepares it: keys of the scene that choose a solver are taken out of it, and the files that it names,
  /// which are sought from `folder`, are made absolute, for it is written into the folder of results. Throws
  /// Error where no such solvers are known.
  SolverBenchmark(scene::Value scene, const std::filesystem::path& folder, std::string name,
                  const deformation::SolidModel& body, SolverBenchmarkOptions options);

  /// Finds the optimum, runs the solvers and adds the files, which appear when the caller commits. Outcomes
  /// go to the log. Throws Error of the kind `stopped` where the monitor's token asks to stop before the
  /// optimum is known; later it ends the solvers that are still to run.
  void run(OutputFolder& folder, const Monitor& monitor);

  /// Returns whether all solvers have run.
  bool whole() const { return comparison_.candidates.size() == chosen_.size(); }
  /// Returns how many of how many solvers have run, in one line.
  std::string verdict() const;

 private:
  void take_solver_keys();
  void name_files_from_anywhere(const std::filesystem::path& folder);
  void find_optimum(const Monitor& monitor);
  void write(OutputFolder& folder) const;

  scene::Value scene_;
  SolverBenchmarkOptions options_;
  std::vector<baselines::SolverInfo> chosen_;
  SolverComparison comparison_;
  SolverRuns runs_;
};

}  // namespace isostretch::comparison

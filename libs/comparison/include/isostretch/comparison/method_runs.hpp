#pragma once

#include <isostretch/comparison/method_comparison.hpp>
#include <isostretch/core/stop_token.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::comparison {

/// Runs of this very program with one method on one problem each, every one in a process of its own. A run
/// that is there already, made of the same, is not made again.
struct MethodRuns {
  std::filesystem::path scene_file;  ///< The scene.
  std::filesystem::path out;         ///< The folder, in which runs are in "runs" and "optimum".
  scene::ComparisonLimits limits;    ///< Limits of each run.
  int threads = 0;                   ///< 0: as the program likes
  std::vector<std::string> plugins;  ///< files
  /// All that times depend on besides the program: threads and machine. The environment may choose the number
  /// of threads and more, and a folder may come from another machine.
  std::string environment;
  StopToken stop = {};  ///< Ends runs.

  /// Returns that run of a method on a problem.
  MethodRun repetition(const ComparedProblem& problem, const std::string& method, int number) const;
  /// Returns the run of the default method from where that run of `method` ended until round-off; no limit of
  /// time ends it.
  MethodRun polished(const ComparedProblem& problem, const std::string& method, const MethodRun& best) const;
};

}  // namespace isostretch::comparison

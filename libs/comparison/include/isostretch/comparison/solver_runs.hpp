#pragma once

#include <isostretch/comparison/solver_comparison.hpp>
#include <isostretch/core/stop_token.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::comparison {

/// Runs of this very program with one solver each, on one frame of a scene, every one in its own process. A
/// run that is there already, made of the same, is not made again.
struct SolverRuns {
  std::filesystem::path scene_file;     ///< The scene.
  std::filesystem::path out;            ///< runs are in its folder "runs"
  std::filesystem::path weights_cache;  ///< Folder of the handles' weights.
  std::string identity;     ///< All that results depend on besides the program and the arguments of a run
  int refine = 1;           ///< Factor of the cells of a generated body.
  int frame = 1;            ///< The frame.
  int threads = 0;          ///< 0: as the program likes
  double gap = 0;           ///< Relative gap that is asked for.
  double time_limit = 0;    ///< seconds; 0: none
  double memory_limit = 0;  ///< megabytes; 0: none
  StopToken stop = {};      ///< Ends runs.

  /// Returns what came of that repetition, counted from 0, of a solver.
  SolverCandidate repetition(const baselines::SolverInfo& info, int number) const;
  /// Returns what comes of so many repetitions of a solver, see median_candidate(). A request of `stop` ends
  /// them after the present one.
  SolverCandidate candidate(const baselines::SolverInfo& info, int repetitions) const;
  /// Returns the run that is to find the optimum, to a relative gap of 1e-9: no limit ends it.
  SolverCandidate optimum() const;
};

}  // namespace isostretch::comparison

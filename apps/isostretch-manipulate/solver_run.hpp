#pragma once

#include "comparison.hpp"

#include <isostretch/baselines/solver.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::app::manipulate {

// One run of a solver, in a folder of its own.
struct Run {
  std::string solver;
  double gap = 0;
  double time_limit = 0;    // 0: none
  double memory_limit = 0;  // megabytes; 0: none
  int max_iterations = 0;   // 0: as the scene has it
  std::filesystem::path folder;
};

// Runs of this very program with one solver each, on one frame of a scene, every one in its own process.
struct SolverRuns {
  std::filesystem::path scene_file, weights_cache;
  std::string identity;  // what results depend on besides the program and the arguments of a run
  int refine = 1, frame = 1;
  int threads = 0;  // 0: as the program likes

  // What came of it, made now or, of the same, before.
  Candidate candidate(const baselines::SolverInfo& info, const Run& run) const;

 private:
  std::vector<std::string> arguments(const Run& run) const;
};

}  // namespace isostretch::app::manipulate

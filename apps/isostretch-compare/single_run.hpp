#pragma once

#include <isostretch/core/output_folder.hpp>
#include <isostretch/scene/comparison_limits.hpp>
#include <isostretch/scene/value.hpp>
#include "common/exit_code.hpp"

#include <isostretch/scene/value.hpp>

#include <filesystem>
#include <string>

namespace isostretch::app::compare {

// One method on one problem of a scene, in this process.
struct SingleRun {
  std::string problem, method;
  scene::ComparisonLimits limits;
  std::filesystem::path from;  // positions to start from; empty: the problem's own start
  std::filesystem::path out;
};

// Writes trace.csv, summary.json and positions.bin, all together or none.
ExitCode run_single(const SingleRun& run, const scene::Value& scene, const std::filesystem::path& scene_file);

}  // namespace isostretch::app::compare

#pragma once

#include "common/look_flags.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace isostretch::app::manipulate {

// Frames to make, both included.
struct FrameRange {
  int first = 1, last = 1;
};

// What does not belong to the scene: it changes no result.
struct Options {
  std::filesystem::path out;
  std::optional<FrameRange> range;  // none: all
  double time_limit = 0;            // seconds; 0: none
  double memory_limit = 0;          // megabytes, of a rival's process; 0: none
  std::string compare;              // solvers, as on the command line; empty: none
  int repetitions = 1;              // of each of them
  bool picture = true;
  bool glb = false;
  LookFlags look;
  std::filesystem::path weights_cache;  // empty: none
};

}  // namespace isostretch::app::manipulate

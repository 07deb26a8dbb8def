#pragma once

#include "common/look_flags.hpp"

#include <filesystem>

namespace isostretch::app::deform {

// What does not belong to the scene: it changes no result.
struct Options {
  std::filesystem::path out;
  bool restart = false;
  int stop_after = -1;  // frames made in this run; -1: all
  bool picture = true;
  bool glb = false;
  LookFlags look;
};

}  // namespace isostretch::app::deform

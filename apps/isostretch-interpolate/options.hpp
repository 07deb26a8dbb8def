#pragma once

#include "common/deformation_names.hpp"

#include <isostretch/deformation/interpolation_options.hpp>
#include <isostretch/scene/value.hpp>

#include <filesystem>

namespace isostretch::app::interpolate {

struct Options : deformation::InterpolationOptions {
  scene::Value value;                   // the scene, with what the command line adds
  std::filesystem::path first, second;  // meshes
  std::filesystem::path out;
  MeshRepair repair;
  FrameFormat format = FrameFormat::vtu;
  bool pictures = true;
  bool glb = false;
  bool check = false;  // look at the poses, and make nothing
};

}  // namespace isostretch::app::interpolate

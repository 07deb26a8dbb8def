#pragma once

#include "common/deformation_names.hpp"

#include "common/frames.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/interpolation_options.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace isostretch::app::interpolate {

using deformation::Continuation;
inline constexpr ChoiceNames<Continuation, 2> guess_names{
    {{"previous", Continuation::previous}, {"extrapolate", Continuation::extrapolate}}};

struct Options : deformation::InterpolationOptions {
  std::filesystem::path first, second;  // meshes
  std::filesystem::path out;
  MeshRepair repair;
  std::string energy = "symmetric_arap";
  std::map<std::string, double> parameters = {};
  FrameFormat format = FrameFormat::vtu;
  bool pictures = true;
  bool glb = false;
  bool check = false;  // look at the poses, and make nothing
};

}  // namespace isostretch::app::interpolate

#pragma once

#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/handles/rotation_blend.hpp>
#include <isostretch/sdp_penalty/options.hpp>

#include <limits>

namespace isostretch::deformation {

/// Where the elements' ex-rotations come from.
enum class Rotations {
  biharmonic,  ///< those of the handles, blended by bounded biharmonic weights
  none         ///< the identity everywhere
};

/// What the elastic energy of an element counts: its volume (area), or 1.
enum class ElementWeights { volume, unit };

/// What lengths are measured in by the term of the soft handles.
enum class LengthUnit { diagonal, mesh };

/// How a body is manipulated without inverting an element (Liu et al. 2016); see sdp_penalty::Problem for
/// alpha, incompressibility, margin and largest_stretch.
struct ManipulationOptions {
  HandleScript script = {};
  double alpha = 1e4;
  ElementWeights weights = ElementWeights::volume;
  LengthUnit units = LengthUnit::diagonal;
  double incompressibility = 0;  ///< kappa
  double margin = 0;
  double largest_stretch = std::numeric_limits<double>::infinity();
  int relinearize = 0;  ///< rounds with the rotations of the round before, after the given ones
  Rotations rotations = Rotations::biharmonic;
  handles::RotationBlend blend = handles::RotationBlend::angle;
  sdp_penalty::Options solver = {};
};

}  // namespace isostretch::deformation

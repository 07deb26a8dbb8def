#pragma once

#include "common/choice_names.hpp"
#include "common/frames.hpp"
#include "common/handle_script.hpp"
#include "common/output_folder.hpp"

#include <isostretch/handles/rotation_blend.hpp>
#include <isostretch/sdp_penalty/options.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace isostretch::app::manipulate {

// Where the elements' ex-rotations come from.
enum class Rotations {
  biharmonic,  // those of the handles, blended by bounded biharmonic weights
  none         // the identity everywhere
};
inline constexpr ChoiceNames<Rotations, 2> rotations_names{
    {{"biharmonic", Rotations::biharmonic}, {"none", Rotations::none}}};

enum class Weights { volume, unit };
inline constexpr ChoiceNames<Weights, 2> weights_names{
    {{"volume", Weights::volume}, {"unit", Weights::unit}}};

// What lengths are measured in by the term of the soft handles.
enum class Units { diagonal, mesh };
inline constexpr ChoiceNames<Units, 2> units_names{{{"diagonal", Units::diagonal}, {"mesh", Units::mesh}}};

inline constexpr ChoiceNames<handles::RotationBlend, 4> blend_names{
    {{"angle", handles::RotationBlend::angle},
     {"quaternion", handles::RotationBlend::quaternion},
     {"aligned_quaternion", handles::RotationBlend::aligned_quaternion},
     {"rotation_vector", handles::RotationBlend::rotation_vector}}};

// How a picture lies on the plane of the mesh.
enum class PhotoFit {
  box,    // on the box around the mesh at rest
  pixels  // a pixel is a unit, the origin its lower left corner
};
inline constexpr ChoiceNames<PhotoFit, 2> photo_fit_names{
    {{"box", PhotoFit::box}, {"pixels", PhotoFit::pixels}}};

// What is up in pictures.
inline constexpr ChoiceNames<int, 3> up_names{{{"x", 0}, {"y", 1}, {"z", 2}}};

struct PhotoSpec {
  std::filesystem::path file;
  PhotoFit fit = PhotoFit::box;
};

// All that results depend on, besides the body.
struct Scene {
  Json json;  // as it was read, with what the command line adds
  HandleScript script = {};
  double alpha = 1e4;
  Weights weights = Weights::volume;
  Units units = Units::diagonal;
  double incompressibility = 0;  // kappa
  double margin = 0;
  double largest_stretch = std::numeric_limits<double>::infinity();
  int relinearize = 0;  // rounds with the rotations of the round before, after the given ones
  Rotations rotations = Rotations::biharmonic;
  handles::RotationBlend blend = handles::RotationBlend::angle;
  sdp_penalty::Options solver = {};
  std::string rival = {};  // solver of `baselines` in its place; empty: none
  FrameFormat format = FrameFormat::vtu;
  int up = -1;  // of pictures; -1: guessed
};

}  // namespace isostretch::app::manipulate

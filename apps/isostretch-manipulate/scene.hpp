#pragma once

#include "common/frames.hpp"
#include "common/output_folder.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/deformation/manipulation_options.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace isostretch::app::manipulate {

using deformation::ElementWeights;
using deformation::LengthUnit;
using deformation::Rotations;

inline constexpr ChoiceNames<Rotations, 2> rotations_names{
    {{"biharmonic", Rotations::biharmonic}, {"none", Rotations::none}}};
inline constexpr ChoiceNames<ElementWeights, 2> weights_names{
    {{"volume", ElementWeights::volume}, {"unit", ElementWeights::unit}}};
inline constexpr ChoiceNames<LengthUnit, 2> units_names{
    {{"diagonal", LengthUnit::diagonal}, {"mesh", LengthUnit::mesh}}};

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
struct Scene : deformation::ManipulationOptions {
  Json json;               // as it was read, with what the command line adds
  std::string rival = {};  // solver of `baselines` in the place of the library's; empty: none
  FrameFormat format = FrameFormat::vtu;
  int up = -1;  // of pictures; -1: guessed
};

}  // namespace isostretch::app::manipulate

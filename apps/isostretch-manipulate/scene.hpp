#pragma once

#include "common/deformation_names.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/deformation/manipulation_options.hpp>
#include <isostretch/scene/value.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace isostretch::app::manipulate {

// How a picture lies on the plane of the mesh.
enum class PhotoFit {
  box,    // on the box around the mesh at rest
  pixels  // a pixel is a unit, the origin its lower left corner
};
constexpr ChoiceNames<PhotoFit, 2> choice_names(PhotoFit) {
  return {{{"box", PhotoFit::box}, {"pixels", PhotoFit::pixels}}};
}

// What is up in pictures.
inline constexpr ChoiceNames<int, 3> up_names{{{"x", 0}, {"y", 1}, {"z", 2}}};

struct PhotoSpec {
  std::filesystem::path file;
  PhotoFit fit = PhotoFit::box;
};

// All that results depend on, besides the body.
struct Scene : deformation::ManipulationOptions {
  scene::Value value;      // as it was read, with what the command line adds
  std::string rival = {};  // solver of `baselines` in the place of the library's; empty: none
  FrameFormat format = FrameFormat::vtu;
  int up = -1;  // of pictures; -1: guessed
};

}  // namespace isostretch::app::manipulate

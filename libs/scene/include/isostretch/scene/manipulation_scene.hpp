#pragma once

#include <isostretch/core/choice_names.hpp>
#include <isostretch/deformation/frame_file.hpp>
#include <isostretch/deformation/manipulation_options.hpp>
#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/scene/value.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::scene {

/// How a picture lies on the plane of a mesh.
enum class PhotoFit {
  box,    ///< on the box around the mesh at rest
  pixels  ///< a pixel is a unit, the origin its lower left corner
};
/// Returns the names of the choices, as scenes and command lines have them.
constexpr ChoiceNames<PhotoFit, 2> choice_names(PhotoFit) {
  return {{{"box", PhotoFit::box}, {"pixels", PhotoFit::pixels}}};
}

/// A picture on a flat body.
struct PhotoSpec {
  std::filesystem::path file;    ///< The file.
  PhotoFit fit = PhotoFit::box;  ///< How it lies on the mesh.
};

/// Returns width and height of a picture in pixels. Throws Error naming the file.
using PhotoSize = std::function<std::array<int, 2>(const std::filesystem::path& file)>;

/// Reads "photo" of a scene, whose file is sought from `folder`. Throws Error naming the key by its path.
std::optional<PhotoSpec> read_photo_spec(const Value& scene, const std::filesystem::path& folder);

/// Reads the body of a scene as read_solid() does, or {"photo_grid": {"cells": N}}: so many square cells
/// along the longer side of its picture, which has length 1. Cells of a generated body are multiplied by
/// `refine`. Throws Error naming the key by its path.
deformation::SolidSpec read_manipulated_solid(const Value& scene, const std::filesystem::path& folder,
                                              int refine, const PhotoSize& photo_size);

/// Throws Error unless the elements of the body are linear triangles or tets.
void require_linear(const deformation::SolidModel& body);

/// All that the results of a manipulation depend on, besides the body.
struct ManipulationScene : deformation::ManipulationOptions {
  Value value;             ///< as it was read
  std::string rival = {};  ///< another solver in the place of the library's; empty: none
  deformation::FrameFormat format = deformation::FrameFormat::vtu;  ///< Format of files of frames.
  int up = -1;  ///< axis that is up in pictures; -1: guessed
};

/// Reads how a body of that dimension is manipulated, see read_manipulation(), "format", "up" and "rival",
/// which must be one of those named. Throws Error naming the key by its path.
ManipulationScene read_manipulation_scene(const Value& scene, int dim,
                                          const std::vector<std::string>& rivals);

/// Sets a picture: another file, another fit, or both. Throws Error naming --photo-fit where there is no
/// picture that could have it.
void set_photo(Value& scene, const std::optional<std::string>& file, const std::optional<std::string>& fit);

/// Puts a rival in the place of the solver that the scene chose.
void set_rival(Value& scene, const std::string& rival);

}  // namespace isostretch::scene

#pragma once

#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/scene/node.hpp>

#include <filesystem>

namespace isostretch::scene {

/// Reads "mesh", a file that is sought from `folder` or a generated body such as {"bar": ...}, "order" and
/// "quadrature" of a scene. Throws Error naming the key by its path.
deformation::SolidSpec read_solid(const Node& scene, const std::filesystem::path& folder);

}  // namespace isostretch::scene

#pragma once

#include "common/deformation_names.hpp"

#include "scene.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::app::manipulate {

// The picture and the body first, for what the rest means depends on the dimension of the body. Files are
// looked for in `folder`; cells of a generated body are multiplied by `refine`. All throw Error naming the
// key by its path.
std::optional<PhotoSpec> read_photo_spec(const scene::Value& value, const std::filesystem::path& folder);
SolidSpec read_body_spec(const scene::Value& value, const std::filesystem::path& folder, int refine);
Scene read_scene(const scene::Value& value, int dim);

// Throws Error unless its elements are linear triangles or tets.
void require_linear(const SolidModel& body);

}  // namespace isostretch::app::manipulate

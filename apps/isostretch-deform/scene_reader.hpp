#pragma once

#include "common/deformation_names.hpp"

#include "scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::app::deform {

// The keys of a scene, docs/apps/isostretch-deform.md explains them.
std::vector<std::string> scene_keys();

// The body and the solver's options first, for what the rest means depends on the dimension of the body.
// Files are looked for in `folder`. All throw Error naming the key by its path.
SolidSpec read_body_spec(const Json& json, const std::filesystem::path& folder);
newton::Options read_solver(const Json& json);
Scene read_scene(const Json& json, int dim);

// The key "solver" for these options.
Json solver_json(const newton::Options& options);

}  // namespace isostretch::app::deform

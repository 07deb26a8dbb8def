#pragma once

#include "common/body.hpp"
#include "common/json_value.hpp"

#include <filesystem>

namespace isostretch::app {

// The key "mesh" of a scene: a file, sought from `folder`, or {"bar": ...} and the like. Throws Error naming
// the key by its path.
void read_mesh(const JsonValue& mesh, const std::filesystem::path& folder, BodySpec& spec);

}  // namespace isostretch::app

#pragma once

#include "common/deformation_names.hpp"

#include "common/json_value.hpp"
#include "common/scene_input.hpp"

#include <filesystem>
#include <utility>

namespace isostretch::app {

// The key "mesh" of a scene: a file, sought from `folder`, or {"bar": ...} and the like. Throws Error naming
// the key by its path.
void read_mesh(const JsonValue& mesh, const std::filesystem::path& folder, SolidSpec& spec);

/// Runs what loads the body: faults of a file are its own, those of a generated body are its scene's.
template <class Work>
auto reading_body(const std::filesystem::path& input, const SolidSpec& spec, Work&& work) {
  if (spec.generated) return reading_scene(input, std::forward<Work>(work));
  return with_error_kind(ErrorKind::input, std::forward<Work>(work));
}

}  // namespace isostretch::app

#pragma once

#include <isostretch/scene/value.hpp>

#include <string>
#include <vector>

namespace isostretch::scene {

/// Returns the JSON Schema of what is not made of options: meshes, handles, selections, energies, by name.
const Value& definitions();

/// Returns the keys of the object that a definition describes.
std::vector<std::string> keys_of(const std::string& definition);

}  // namespace isostretch::scene

#pragma once

#include "report.hpp"

#include <string>

namespace isostretch::app::parameterize {

// The result as binary glTF with a checkerboard in it, whose squares are those of model.png. Its uv are
// those of the OBJ; how often the picture repeats is said by the material.
std::string textured_glb(const Result& result);

}  // namespace isostretch::app::parameterize

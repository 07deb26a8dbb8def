#pragma once

#include "input.hpp"

#include <isostretch/parameterization/parameterize.hpp>

#include <string>

namespace isostretch::app::parameterize {

/// Text of the OBJ file with the layout as texture coordinates. A model read from OBJ is written as it stands
/// in its file, everything else kept to the letter; notices tell what could not be kept.
std::string uv_file(const Input& input, const parameterization::Parameterization& result);

}  // namespace isostretch::app::parameterize

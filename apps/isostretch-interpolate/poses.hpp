#pragma once

#include "common/body.hpp"

#include <filesystem>

namespace isostretch::app::interpolate {

// Two poses of one mesh. Each is a rest shape of its own.
struct Poses {
  Body first, second;
};

// Throws Error naming the file and the element: for elements that cannot be used, and for the first one that
// is not the same in both.
Poses read_poses(const std::filesystem::path& first, const std::filesystem::path& second);

}  // namespace isostretch::app::interpolate

#pragma once

#include "common/body.hpp"
#include "common/exit_code.hpp"

#include <filesystem>

namespace isostretch::app::interpolate {

// Two poses of one mesh. Each is a rest shape of its own.
struct Poses {
  Body first, second;
};

// Throws Error naming the file and the element: for elements that cannot be used, and for the first one that
// is not the same in both; for flat poses that lie in different planes.
Poses read_poses(const std::filesystem::path& first, const std::filesystem::path& second,
                 const MeshRepair& repair);

/// Prints what is to be known of both poses, and whether they belong together: ExitCode::input if not.
ExitCode check_poses(const std::filesystem::path& first, const std::filesystem::path& second,
                     const MeshRepair& repair);

}  // namespace isostretch::app::interpolate

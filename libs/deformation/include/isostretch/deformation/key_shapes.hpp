#pragma once

#include <isostretch/deformation/solid_model.hpp>

#include <filesystem>
#include <string>

namespace isostretch::deformation {

/// Two poses of one mesh. Each is a rest shape of its own.
struct KeyShapes {
  SolidModel first, second;
};

/// Throws Error naming the file and the element: for elements that cannot be used, and for the first one that
/// is not the same in both; for flat poses that lie in different planes.
KeyShapes read_key_shapes(const std::filesystem::path& first, const std::filesystem::path& second,
                          const MeshRepair& repair);

/// Throws Error, naming the files, unless both have the same vertices and elements in the same order, and
/// flat ones the same plane.
void require_pair(const KeyShapes& shapes, const std::string& first, const std::string& second);

}  // namespace isostretch::deformation

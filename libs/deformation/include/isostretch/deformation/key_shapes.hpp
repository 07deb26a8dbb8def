#pragma once

#include <isostretch/deformation/solid_model.hpp>

#include <filesystem>
#include <string>

namespace isostretch::deformation {

/// Two shapes of one mesh, each of which is a rest shape of its own.
struct KeyShapes {
  /// The shape at time 0.
  SolidModel first, second;  ///< The shape at time 1.
};

/// Reads two key shapes. Throws Error naming the file and the element: for elements that cannot be used, for
/// the first one that is not the same in both, and for flat shapes that lie in different planes.
KeyShapes read_key_shapes(const std::filesystem::path& first, const std::filesystem::path& second,
                          const MeshRepair& repair);

/// Throws Error, naming the files, unless both shapes have the same vertices and elements in the same order,
/// and flat ones the same plane.
void require_pair(const KeyShapes& shapes, const std::string& first, const std::string& second);

}  // namespace isostretch::deformation

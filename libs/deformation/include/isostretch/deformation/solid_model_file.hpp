#pragma once

#include <isostretch/deformation/solid_model.hpp>

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

// From a file of elements to a body, step by step: what load_solid() and check_solid() share.

/// Reads the elements of the file, with the treatment of faces and of welding in spec.repair; tells in a
/// notice what was welded. Throws Error naming the file.
mesh::ElementMesh read_solid_file(const SolidSpec& spec);

/// Moves flat elements from their plane to z = 0 and returns the plane, none where that is z = 0. Throws
/// Error naming a vertex that stands out of the plane by more than rounding; then only some vertices have
/// moved.
std::optional<Plane> flatten(mesh::ElementMesh& m);

/// Turns solid elements that are all numbered the other way round, and with repair.repair those among others,
/// leaving out copies; tells in a notice what was done. Throws Error naming the first such element otherwise.
void mend(mesh::ElementMesh& m, const MeshRepair& repair, const std::string& file);

/// Returns an element with its vertices: "tet 17 (vertices 3 9 12 40)".
std::string element_text(const mesh::ElementMesh& m, int e);

/// Returns a count with the name of a shape: "1 tet", "1,234 tets".
std::string counted(std::ptrdiff_t count, mesh::Shape shape);

/// Returns for every vertex whether it belongs to an element.
std::vector<bool> used_vertices(const mesh::ElementMesh& m);

/// Returns the box around the used vertices.
Eigen::AlignedBox3d box_of(const mesh::Points3& vertices, const std::vector<bool>& used);

}  // namespace isostretch::deformation

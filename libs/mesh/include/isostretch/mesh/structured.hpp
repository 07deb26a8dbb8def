#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

/// // Sizes below 1, lengths that are not positive, and meshes of more than 2^31 indices throw Error.

/// Returns nx x ny rectangles from the origin to (width, height), with the vertices of grid(). Throws Error
/// for counts below 1, lengths that are not positive, and more than 2^31 indices.
QuadMesh quad_grid(int nx, int ny, double width = 1, double height = 1);

/// Returns `layers` hexahedra over every quad, from z = 0 to `height`, with the vertices layer by layer.
/// Throws Error for layers below 1, a height that is not positive, and more than 2^31 indices.
HexMesh extrude(const QuadMesh& mesh, int layers, double height = 1);

/// Returns nx x ny x nz boxes from the origin to (size_x, size_y, size_z), with the vertices of tet_bar().
/// Throws Error for counts below 1, lengths that are not positive, and more than 2^31 indices.
HexMesh hex_bar(int nx, int ny, int nz, double size_x = 1, double size_y = 1, double size_z = 1);

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

// Sizes below 1, lengths that are not positive, and meshes of more than 2^31 indices throw Error.

/// nx x ny rectangles from the origin to (width, height); vertices as those of grid().
QuadMesh quad_grid(int nx, int ny, double width = 1, double height = 1);

/// `layers` hexes over every quad, from z = 0 to `height`; vertices layer by layer.
HexMesh extrude(const QuadMesh& mesh, int layers, double height = 1);

/// nx x ny x nz boxes from the origin to (size_x, size_y, size_z); vertices as those of tet_bar().
HexMesh hex_bar(int nx, int ny, int nz, double size_x = 1, double size_y = 1, double size_z = 1);

}  // namespace isostretch::mesh

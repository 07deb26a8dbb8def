#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

// Sizes below 1 (level below 0), lengths that are not positive, and meshes of more than 2^31 indices throw
// Error.

// nx x ny rectangles cut into two triangles each, in the plane z = 0 from the origin to (width, height).
SurfaceMesh grid(int nx, int ny, double width = 1, double height = 1);

// Unit disc in the plane z = 0 of `rings` rings: 6 rings^2 triangles, 1 + 3 rings (rings + 1) vertices.
SurfaceMesh disc(int rings);

// Unit sphere: the icosahedron subdivided `level` times, 20 * 4^level triangles.
SurfaceMesh icosphere(int level);

// A disk that is far from flat: a head-like cap bent well beyond a hemisphere, with nose, eye sockets and
// mouth. The stand-in for a scanned face where no data is at hand; connectivity of disc(rings).
SurfaceMesh procedural_face(int rings);

// nx x ny x nz boxes cut into six tetrahedra each (conforming, all of positive volume), from the origin to
// (size_x, size_y, size_z).
TetMesh tet_bar(int nx, int ny, int nz, double size_x = 1, double size_y = 1, double size_z = 1);

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

// Sizes below 1 (level below 0), lengths that are not positive, and meshes of more than 2^31 indices throw
// Error.

/// nx x ny rectangles cut into two triangles each, in the plane z = 0 from the origin to (width, height).
SurfaceMesh grid(int nx, int ny, double width = 1, double height = 1);

/// nx x ny rectangles cut into four triangles each around their centres, in the plane z = 0 from the origin
/// to (width, height). The (nx + 1)(ny + 1) corners come first, row by row as those of grid(), then the
/// centres.
SurfaceMesh crossed_grid(int nx, int ny, double width = 1, double height = 1);

/// Unit disc in the plane z = 0 of `rings` rings: 6 rings^2 triangles, 1 + 3 rings (rings + 1) vertices.
SurfaceMesh disc(int rings);

/// Unit sphere: the icosahedron subdivided `level` times, 20 * 4^level triangles.
SurfaceMesh icosphere(int level);

/// A disk that is far from flat: a head-like cap bent well beyond a hemisphere, with nose, eye sockets and
/// mouth. The stand-in for a scanned face where no data is at hand; connectivity of disc(rings).
SurfaceMesh procedural_face(int rings);

/// nx x ny x nz boxes cut into six tetrahedra each (conforming, all of positive volume), from the origin to
/// (size_x, size_y, size_z).
TetMesh tet_bar(int nx, int ny, int nz, double size_x = 1, double size_y = 1, double size_z = 1);

/// Unit ball: n x n x n cubes of five tetrahedra, mirror images of their neighbours (n even, otherwise
/// Error), moved from [-1, 1]^3 to the ball. 5 n^3 tetrahedra, all of positive volume; vertices with z
/// fastest, x slowest. Quality (1 of a regular tetrahedron, 6 sqrt(2) volume / (root mean square edge)^3)
/// stays above 0.3 for any n but for the 12 n - 16 tetrahedra across the cube's edges: all their corners are
/// on the sphere, and they flatten like 1 / n.
TetMesh ball(int n);

/// A hippo-like animal, n >= 12 cells long: the unit interval along x with the snout at x = 1, the legs down
/// -z, left and right of y = 0. One piece with a manifold boundary, every tetrahedron of quality (see ball)
/// 0.15 at least, most above 0.7. This keeps some vertices of the boundary from the smooth shape: of twenty,
/// three to five are farther from it than 1 % of a cell, one farther than a sixth of a cell, none farther
/// than 0.6.
TetMesh quadruped(int n);

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

/// // Sizes below 1 (level below 0), lengths that are not positive, and meshes of more than 2^31 indices
/// throw Error.

/// Returns nx x ny rectangles in the plane z = 0, from the origin to (width, height), cut into two triangles
/// each. Throws Error for counts below 1, lengths that are not positive, and more than 2^31 indices.
SurfaceMesh grid(int nx, int ny, double width = 1, double height = 1);

/// Returns nx x ny rectangles in the plane z = 0, from the origin to (width, height), cut into four triangles
/// each around their centres. The (nx + 1)(ny + 1) corners come first, row by row as those of grid(), then
/// the centres. Throws Error for counts below 1, lengths that are not positive, and more than 2^31 indices.
SurfaceMesh crossed_grid(int nx, int ny, double width = 1, double height = 1);

/// Returns the unit disk in the plane z = 0, made of `rings` rings: 6 rings^2 triangles, 1 + 3 rings (rings +
/// 1) vertices. Throws Error for rings below 1 and more than 2^31 indices.
SurfaceMesh disc(int rings);

/// Returns the unit sphere as an icosahedron that is subdivided `level` times: 20 * 4^level triangles. Throws
/// Error for a level below 0 and more than 2^31 indices.
SurfaceMesh icosphere(int level);

/// Returns a disk that is far from flat: a head-like cap bent well beyond a hemisphere, with nose, eye
/// sockets and mouth, and the connectivity of disc(rings). It stands in for a scanned face where no data is
/// at hand.
SurfaceMesh procedural_face(int rings);

/// Returns nx x ny x nz boxes, from the origin to (size_x, size_y, size_z), cut into six tetrahedra each;
/// conforming, all of positive volume. Throws Error for counts below 1, lengths that are not positive, and
/// more than 2^31 indices.
TetMesh tet_bar(int nx, int ny, int nz, double size_x = 1, double size_y = 1, double size_z = 1);

/// Returns the unit ball: n x n x n cubes of five tetrahedra, mirror images of their neighbours, moved from
/// [-1, 1]^3 to the ball. 5 n^3 tetrahedra, all of positive volume; vertices with z fastest, x slowest.
/// Quality (1 of a regular tetrahedron, 6 sqrt(2) volume / (root mean square edge)^3) stays above 0.3 for any
/// n but for the 12 n - 16 tetrahedra across the cube's edges: all their corners are on the sphere, and they
/// flatten like 1 / n. Throws Error unless n is even and positive.
TetMesh ball(int n);

/// Returns a hippo-like animal, n >= 12 cells long: the unit interval along x with the snout at x = 1, the
/// legs down -z, left and right of y = 0. One piece with a manifold boundary, every tetrahedron of quality
/// (see ball()) 0.15 at least, most above 0.7. This keeps some vertices of the boundary from the smooth
/// shape: of twenty, three to five are farther from it than 1 % of a cell, one farther than a sixth of a
/// cell, none farther than 0.6. Throws Error for n below 12.
TetMesh quadruped(int n);

}  // namespace isostretch::mesh

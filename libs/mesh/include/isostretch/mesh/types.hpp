#pragma once

#include <Eigen/Core>

namespace isostretch::mesh {

/// A matrix with a row for every vertex or element. DontAlign makes Eigen take the memory from malloc
/// whatever instruction set it is compiled for, so a mesh may be made here and resized or freed in code built
/// with -march=native. In all other respects these are plain row-major matrices: they convert to and from
/// every other Eigen matrix by assignment.
template <class Scalar, int Columns>
using Rows = Eigen::Matrix<Scalar, Eigen::Dynamic, Columns, Eigen::RowMajor | Eigen::DontAlign>;

/// Points in the plane, a row each.
using Points2 = Rows<double, 2>;
/// Points in space, a row each.
using Points3 = Rows<double, 3>;
/// Triangles, a row of 3 vertex indices each.
using Triangles = Rows<int, 3>;
/// Tetrahedra, a row of 4 vertex indices each.
using Tets = Rows<int, 4>;
/// Quadrangles, a row of 4 vertex indices each.
using Quads = Rows<int, 4>;
/// Hexahedra, a row of 8 vertex indices each, in VTK's order.
using Hexes = Rows<int, 8>;
/// Quadratic triangles, a row of 6 node indices each, in VTK's order.
using QuadraticTriangles = Rows<int, 6>;
/// Quadratic tetrahedra, a row of 10 node indices each, in VTK's order.
using QuadraticTets = Rows<int, 10>;

/// A triangle mesh in space, with or without texture coordinates. Vertices and triangles count from 0.
/// Triangles are counter-clockwise seen from outside.
struct SurfaceMesh {
  Points3 vertices;     ///< V x 3.
  Triangles triangles;  ///< F x 3, indices into vertices.
  Points2 uv;           ///< Texture coordinates, T x 2, or empty.
  /// Texture coordinates of the corners of triangles, F x 3, indices into uv, or empty.
  Triangles uv_triangles;

  /// Returns whether the mesh has texture coordinates.
  bool has_uv() const { return uv_triangles.rows() > 0; }
};

/// A mesh of tetrahedra. The volume (p1 - p0) x (p2 - p0) . (p3 - p0) / 6 of a tetrahedron is positive.
struct TetMesh {
  Points3 vertices;  ///< V x 3.
  Tets tets;         ///< T x 4, indices into vertices.
};

// Nodes of an element are in VTK's order throughout; a node on an edge is between the two corners named.

/// A mesh of bilinear quadrangles in the plane: four corners, counter-clockwise.
struct QuadMesh {
  Points2 vertices;  ///< V x 2.
  Quads quads;       ///< Q x 4, indices into vertices.
};

/// A mesh of trilinear hexahedra: four corners counter-clockwise seen from the other four, then those in the
/// same order.
struct HexMesh {
  Points3 vertices;  ///< V x 3.
  Hexes hexes;       ///< H x 8, indices into vertices.
};

/// A mesh of quadratic triangles in the plane: three corners counter-clockwise, then nodes on the edges 01,
/// 12, 20. Edges may be curved.
struct QuadraticTriangleMesh {
  Points2 nodes;                 ///< N x 2.
  QuadraticTriangles triangles;  ///< F x 6, indices into nodes.
};

/// A mesh of quadratic tetrahedra: four corners as in TetMesh, then nodes on the edges 01, 12, 20, 03, 13, 23
/// (Gmsh has the last two in the other order). Edges and faces may be curved.
struct QuadraticTetMesh {
  Points3 nodes;       ///< N x 3.
  QuadraticTets tets;  ///< T x 10, indices into nodes.
};

}  // namespace isostretch::mesh

#pragma once

#include <Eigen/Core>

namespace isostretch::mesh {

/// One row per vertex or element. DontAlign makes Eigen take the memory from malloc whatever instruction set
/// it is compiled for, so a mesh may be made here and resized or freed in code built with -march=native.
/// Otherwise these are plain row-major matrices: they convert to and from every other Eigen matrix by
/// assignment.
template <class Scalar, int Columns>
using Rows = Eigen::Matrix<Scalar, Eigen::Dynamic, Columns, Eigen::RowMajor | Eigen::DontAlign>;

using Points2 = Rows<double, 2>;
using Points3 = Rows<double, 3>;
using Triangles = Rows<int, 3>;
using Tets = Rows<int, 4>;
using Quads = Rows<int, 4>;
using Hexes = Rows<int, 8>;
using QuadraticTriangles = Rows<int, 6>;
using QuadraticTets = Rows<int, 10>;

/// Vertices and elements count from 0. Triangles are counter-clockwise seen from outside.
struct SurfaceMesh {
  Points3 vertices;        ///< #V x 3
  Triangles triangles;     ///< #F x 3, into vertices
  Points2 uv;              ///< #T x 2, or empty
  Triangles uv_triangles;  ///< #F x 3, into uv, or empty

  bool has_uv() const { return uv_triangles.rows() > 0; }
};

/// The volume (p1 - p0) x (p2 - p0) . (p3 - p0) / 6 of a tetrahedron is positive.
struct TetMesh {
  Points3 vertices;  ///< #V x 3
  Tets tets;         ///< #T x 4
};

// Nodes of an element are in VTK's order throughout; a node on an edge is between the two corners named.

/// Four corners counter-clockwise, bilinear.
struct QuadMesh {
  Points2 vertices;  ///< #V x 2
  Quads quads;       ///< #Q x 4
};

/// Four corners counter-clockwise seen from the other four, then those in the same order; trilinear.
struct HexMesh {
  Points3 vertices;  ///< #V x 3
  Hexes hexes;       ///< #H x 8
};

/// Three corners counter-clockwise, then nodes on the edges 01, 12, 20. Edges may be curved.
struct QuadraticTriangleMesh {
  Points2 nodes;                 ///< #N x 2
  QuadraticTriangles triangles;  ///< #F x 6
};

/// Four corners as in TetMesh, then nodes on the edges 01, 12, 20, 03, 13, 23 (Gmsh has the last two the
/// other way round). Edges and faces may be curved.
struct QuadraticTetMesh {
  Points3 nodes;       ///< #N x 3
  QuadraticTets tets;  ///< #T x 10
};

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

/// Returns a mesh of quadratic triangles with straight edges: a node in the middle of every edge, shared by
/// all elements around it. Vertices keep their numbers; the new nodes follow in the order in which elements,
/// and the edges of each in VTK's order, come to them. Throws Error naming the triangle when an index is out
/// of range.
QuadraticTriangleMesh quadratic(const Points2& vertices, const Triangles& triangles);
/// Returns a mesh of quadratic tetrahedra with straight edges: a node in the middle of every edge, shared by
/// all elements around it. Vertices keep their numbers; the new nodes follow in the order in which elements,
/// and the edges of each in VTK's order, come to them. Throws Error naming the tetrahedron when an index is
/// out of range.
QuadraticTetMesh quadratic(const TetMesh& mesh);

}  // namespace isostretch::mesh

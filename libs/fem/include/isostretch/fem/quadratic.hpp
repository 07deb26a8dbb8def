#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

/// Quadratic meshes of straight edges: a node in the middle of every edge, shared by all elements around it.
/// Vertices keep their numbers; the new nodes follow in the order in which elements, and the edges of each in
/// VTK's order, come to them. Throw Error naming the element when an index is out of range.
QuadraticTriangleMesh quadratic(const Points2& vertices, const Triangles& triangles);
QuadraticTetMesh quadratic(const TetMesh& mesh);

}  // namespace isostretch::mesh

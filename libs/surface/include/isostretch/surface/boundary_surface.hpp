#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// The boundary of a solid as triangles, and the nodes and elements that these belong to.
struct BoundarySurface {
  SurfaceMesh mesh;                  ///< Triangles counter-clockwise seen from outside.
  std::vector<int> original_vertex;  ///< Node of the solid of every vertex of the surface, ascending.
  std::vector<int> element;          ///< Element behind every triangle.
};

/// Returns the faces of tetrahedra that belong to one element alone; none for a mesh without elements. Throws
/// Error naming the element when an index is out of range.
BoundarySurface boundary_surface(const TetMesh& mesh);
/// Returns the faces of hexahedra that belong to one element alone, cut into two triangles each. Throws Error
/// naming the element when an index is out of range.
BoundarySurface boundary_surface(const HexMesh& mesh);
/// Returns the faces of quadratic tetrahedra that belong to one element alone, cut into four triangles each,
/// through the nodes in the middle of its edges. Throws Error naming the element when an index is out of
/// range.
BoundarySurface boundary_surface(const QuadraticTetMesh& mesh);

}  // namespace isostretch::mesh

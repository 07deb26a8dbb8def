#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// The outside of a solid as triangles, and where they come from.
struct BoundarySurface {
  SurfaceMesh mesh;                  ///< triangles counter-clockwise seen from outside
  std::vector<int> original_vertex;  ///< vertex of the surface -> node of the solid, ascending
  std::vector<int> element;          ///< of every triangle, the element behind it
};

/// Faces that belong to one element alone. A face of a hex becomes two triangles, one of a quadratic tet
/// four, through the nodes in the middle of its edges. Empty for a mesh without elements. Throws Error naming
/// the element when an index is out of range.
BoundarySurface boundary_surface(const TetMesh& mesh);
BoundarySurface boundary_surface(const HexMesh& mesh);
BoundarySurface boundary_surface(const QuadraticTetMesh& mesh);

}  // namespace isostretch::mesh

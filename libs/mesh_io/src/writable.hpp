#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

// Throws Error naming the vertex or element with a coordinate that is not finite or an index out of range, or
// when there are no elements: no reader would take it back. Texture coordinates count where there are any.
void require_writable(const SurfaceMesh& mesh);
void require_writable(const TetMesh& mesh);
void require_writable(const ElementMesh& mesh);

}  // namespace isostretch::mesh

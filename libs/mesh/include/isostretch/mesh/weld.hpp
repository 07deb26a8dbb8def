#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>

namespace isostretch::mesh {

/// Takes vertices for one that are at the same place, or with a tolerance no farther than that from one that
/// was kept before, and returns how many went. Texture coordinates stay with their corners, and elements keep
/// their order and number; vertices that are kept keep their order. Throws Error for a tolerance that is
/// negative or not finite, a coordinate that is not finite, or an index out of range.
int weld(SurfaceMesh& mesh, double tolerance = 0);
/// The same for elements of any kind and their groups.
int weld(ElementMesh& mesh, double tolerance = 0);

}  // namespace isostretch::mesh

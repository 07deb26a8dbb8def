#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// Takes vertices for one that are at the same place, or with a tolerance no farther than that from one that
/// was kept before, and returns how many went. Texture coordinates stay with their corners, and elements keep
/// their order and number; vertices that are kept keep their order. Throws Error for a tolerance that is
/// negative or not finite, a coordinate that is not finite, or an index out of range.
int weld(SurfaceMesh& mesh, double tolerance = 0);
/// The same for elements of any kind and their groups.
int weld(ElementMesh& mesh, double tolerance = 0);

/// Points of which none is at the place of another.
struct WeldedPoints {
  std::vector<double> points;  ///< x, y, z each, in the order of their first appearance
  std::vector<int> index;      ///< into them, of every point given
};

/// Makes one point of those that are equal, or with a tolerance no farther than that from one that was kept
/// before; -0.0 equals 0.0. The first of several within reach is taken. Takes x, y, z each, all finite.
WeldedPoints weld(const std::vector<double>& points, double tolerance);

}  // namespace isostretch::mesh

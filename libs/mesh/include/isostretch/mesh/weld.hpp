#pragma once

#include <isostretch/mesh/element_mesh.hpp>
#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// Makes one vertex of those that are at the same place, or no farther than `tolerance` from one that was
/// kept before, and returns how many vertices went. Texture coordinates stay with their corners, elements
/// keep their order and number, and vertices that are kept keep their order. Throws Error for a tolerance
/// that is negative or not finite, a coordinate that is not finite, or an index out of range.
int weld(SurfaceMesh& mesh, double tolerance = 0);
/// Makes one vertex of those of a mesh of any shape that are at the same place, or no farther than
/// `tolerance` from one that was kept before, and returns how many vertices went. Elements keep their order
/// and number, also in the groups. Throws Error for a tolerance that is negative or not finite, a coordinate
/// that is not finite, or an index out of range.
int weld(ElementMesh& mesh, double tolerance = 0);

/// Points of which none is at the place of another, and the numbers of the points that they were made of.
struct WeldedPoints {
  std::vector<double> points;  ///< x, y, z each, in the order of their first appearance.
  std::vector<int> index;      ///< The index of every given point among those kept.
};

/// Makes one point of those that are equal, or no farther than `tolerance` from one that was kept before;
/// -0.0 equals 0.0. The first of several within reach is taken. Takes x, y, z each, all finite.
WeldedPoints weld(const std::vector<double>& points, double tolerance);

}  // namespace isostretch::mesh

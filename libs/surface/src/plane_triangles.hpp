#pragma once

#include "box_tree.hpp"

#include <isostretch/mesh/types.hpp>

#include <array>
#include <vector>

namespace isostretch::mesh {

// Counter-clockwise, from its lexicographically first corner; of equal triangles there is one, with its
// copies.
struct PlaneTriangle {
  std::array<PlanePoint, 3> corner{};
  std::vector<int> copies;  // triangles of the mesh, ascending
  PlaneBox box() const;
  double copy_count() const { return static_cast<double>(copies.size()); }
};

// The triangles that have an area, brought to size 1 by a power of two so that products neither overflow nor
// vanish, in the order of a Morton curve.
struct PlaneTriangles {
  std::vector<PlaneTriangle> triangles;
  double unit = 1;  // lengths of the mesh over lengths here

  PlaneTriangles(const Points2& uv, const Triangles& mesh);
};

// Whether the open triangles have a point in common; exact.
bool interiors_meet(const PlaneTriangle& a, const PlaneTriangle& b);

}  // namespace isostretch::mesh

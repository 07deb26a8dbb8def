#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// The signed areas of a planar layout, as orientation() finds them.
struct OrientationReport {
  std::vector<int> flipped;    ///< Triangles whose signed area is not positive (NaN included), ascending.
  double smallest_area = 0;    ///< Smallest signed area.
  int smallest_triangle = -1;  ///< Triangle of the smallest signed area, -1 without triangles.
  double total_area = 0;       ///< Sum of signed areas.
};

/// Returns which triangles in the plane are flipped, by a determinant that is exact to one rounding. Throws
/// Error when an index is out of range.
OrientationReport orientation(const Points2& uv, const Triangles& triangles);

/// Returns the number of triangles in the plane whose signed area is not positive. Throws Error when an index
/// is out of range.
inline int count_flipped(const Points2& uv, const Triangles& triangles) {
  return static_cast<int>(orientation(uv, triangles).flipped.size());
}

}  // namespace isostretch::mesh

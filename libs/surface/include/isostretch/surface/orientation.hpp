#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

struct OrientationReport {
  std::vector<int> flipped;    ///< triangles whose signed area is not positive (NaN included), ascending
  double smallest_area = 0;    ///< smallest signed area
  int smallest_triangle = -1;  ///< where; -1: no triangles
  double total_area = 0;       ///< sum of signed areas
};

/// Signed areas of triangles in the plane, with a determinant that is exact to one rounding. Throws Error
/// when an index is out of range.
OrientationReport orientation(const Points2& uv, const Triangles& triangles);

inline int count_flipped(const Points2& uv, const Triangles& triangles) {
  return static_cast<int>(orientation(uv, triangles).flipped.size());
}

}  // namespace isostretch::mesh

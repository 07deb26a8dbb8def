#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

// Row-by-row growth, then one copy into a matrix.
template <class Scalar, int Columns>
Rows<Scalar, Columns> to_rows(const std::vector<Scalar>& values) {
  return Eigen::Map<const Rows<Scalar, Columns>>(values.data(),
                                                 static_cast<Eigen::Index>(values.size()) / Columns, Columns);
}

// Appends the fan of a polygon around its first corner.
inline void append_fan(const std::vector<int>& polygon, std::vector<int>& triangles) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    triangles.insert(triangles.end(), {polygon[0], polygon[i - 1], polygon[i]});
}

}  // namespace isostretch::mesh

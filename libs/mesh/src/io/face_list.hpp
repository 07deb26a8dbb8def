#pragma once

#include <isostretch/mesh/io.hpp>
#include <isostretch/mesh/types.hpp>

#include <string>
#include <vector>

namespace isostretch::mesh {

// Row-by-row growth, then one copy into a matrix.
template <class Scalar, int Columns>
Rows<Scalar, Columns> to_rows(const std::vector<Scalar>& values) {
  return Eigen::Map<const Rows<Scalar, Columns>>(values.data(),
                                                 static_cast<Eigen::Index>(values.size()) / Columns, Columns);
}

// Why a face of so many vertices is not taken; empty if it is.
inline std::string face_fault(std::int64_t corners, const ReadOptions& options) {
  if (corners == 3 || (corners > 3 && options.triangulate_polygons)) return {};
  std::string text = "face with " + std::to_string(corners) + " vertices";
  if (corners > 3) text += ": triangulate the mesh, or let the reader cut polygons into fans";
  return text;
}

// Appends the fan of a polygon around its first corner.
inline void append_fan(const std::vector<int>& polygon, std::vector<int>& triangles) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    triangles.insert(triangles.end(), {polygon[0], polygon[i - 1], polygon[i]});
}

inline SurfaceMesh surface_of(const std::vector<double>& vertices, const std::vector<int>& triangles) {
  return {to_rows<double, 3>(vertices), to_rows<int, 3>(triangles), {}, {}};
}

}  // namespace isostretch::mesh

#include <isostretch/figures/surface_model.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace isostretch::figures {

mesh::Points3 in_unit_ball(const mesh::Points3& vertices, const mesh::Triangles& triangles) {
  double largest = std::numeric_limits<double>::min();  // divided by at once, so that nothing overflows
  for (const int v : triangles.reshaped()) largest = std::max(largest, vertices.row(v).cwiseAbs().maxCoeff());
  Eigen::RowVector3d low = Eigen::RowVector3d::Ones(), high = -low;
  for (const int v : triangles.reshaped()) {
    low = low.cwiseMin(vertices.row(v) / largest);
    high = high.cwiseMax(vertices.row(v) / largest);
  }
  const Eigen::RowVector3d middle = 0.5 * (low + high);
  const double radius = std::max(0.5 * (high - low).norm(), std::numeric_limits<double>::min());
  mesh::Points3 result(vertices.rows(), 3);
  for (Eigen::Index v = 0; v < result.rows(); ++v)
    result.row(v) = ((vertices.row(v) / largest).cwiseMax(low).cwiseMin(high) - middle) / radius;
  return result;
}

mesh::Points3 smooth_normals(const mesh::Points3& vertices, const mesh::Triangles& triangles) {
  mesh::Points3 normals = mesh::Points3::Zero(vertices.rows(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Eigen::RowVector3d p = vertices.row(triangles(t, 0));
    const Eigen::RowVector3d area =
        (vertices.row(triangles(t, 1)) - p).cross(vertices.row(triangles(t, 2)) - p);
    for (int c = 0; c < 3; ++c) normals.row(triangles(t, c)) += area;
  }
  // Not rowwise().normalize(), which divides by zero.
  for (Eigen::Index v = 0; v < normals.rows(); ++v) normals.row(v).normalize();
  return normals;
}

}  // namespace isostretch::figures

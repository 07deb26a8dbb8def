
#include <isostretch/mesh/measure.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/orientation.hpp>

namespace isostretch::mesh {

OrientationReport orientation(const Points2& uv, const Triangles& triangles) {
  require_indices(triangles, uv.rows(), "triangle");
  OrientationReport report;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const double area = signed_area(uv, triangles.row(t));
    report.total_area += area;
    if (!(area > 0)) report.flipped.push_back(static_cast<int>(t));
    if (report.smallest_triangle < 0 || area < report.smallest_area) {
      report.smallest_area = area;
      report.smallest_triangle = static_cast<int>(t);
    }
  }
  return report;
}

}  // namespace isostretch::mesh

#include "accurate.hpp"
#include "require.hpp"

#include <isostretch/mesh/orientation.hpp>

namespace isostretch::mesh {
namespace {

double signed_area(const Points2& uv, const int* v) {
  return 0.5 * product_difference(uv(v[1], 0) - uv(v[0], 0), uv(v[2], 1) - uv(v[0], 1),
                                  uv(v[1], 1) - uv(v[0], 1), uv(v[2], 0) - uv(v[0], 0));
}

}  // namespace

OrientationReport orientation(const Points2& uv, const Triangles& triangles) {
  require_indices(triangles, uv.rows(), "triangle");
  OrientationReport report;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const double area = signed_area(uv, triangles.data() + 3 * t);
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

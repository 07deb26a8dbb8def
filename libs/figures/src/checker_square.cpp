#include <isostretch/figures/parameterization_figures.hpp>

#include <cmath>

namespace isostretch::figures {
namespace {

double layout_area(const mesh::Points2& uv, const mesh::Triangles& triangles) {
  double area = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Eigen::RowVector2d p = uv.row(triangles(t, 0));
    const Eigen::RowVector2d a = uv.row(triangles(t, 1)) - p, b = uv.row(triangles(t, 2)) - p;
    area += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

}  // namespace

// From the area that there is in the end, as not every energy keeps that of the model.
double checker_square(const parameterization::Parameterization& r) {
  const double side = std::sqrt(layout_area(r.layout.uv, r.domain.open().triangles)) / 30;
  return std::isnormal(side) ? side : 1.0;
}

}  // namespace isostretch::figures

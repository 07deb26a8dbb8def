#include "enclosing_rectangle.hpp"
#include "skyline.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/parameterization/pack.hpp>
#include <isostretch/surface/overlap.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace isostretch::parameterization {
namespace {

void require_packable(const std::vector<mesh::Points2>& charts,
                      const std::vector<mesh::Triangles>& triangles) {
  if (charts.size() != triangles.size())
    throw Error("pack: " + std::to_string(charts.size()) + " charts but triangles of " +
                std::to_string(triangles.size()));
  for (std::size_t c = 0; c < charts.size(); ++c) {
    if (triangles[c].rows() == 0) throw Error("pack: chart " + std::to_string(c) + " has no triangles");
    if (!charts[c].allFinite())
      throw Error("pack: chart " + std::to_string(c) + " has a point that is not finite");
  }
}

// Turns the chart so that its smallest enclosing rectangle lies down.
void lay_down(mesh::Points2& chart) {
  const Direction d = smallest_rectangle(chart);
  for (Eigen::Index i = 0; i < chart.rows(); ++i) {
    const double x = chart(i, 0), y = chart(i, 1);
    chart.row(i) << d.x * x + d.y * y, d.x * y - d.y * x;
  }
}

// With its lower left corner at the origin.
Rectangle bounds(mesh::Points2& chart) {
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (Eigen::Index i = 0; i < chart.rows(); ++i)
    for (int d = 0; d < 2; ++d)
      low[d] = std::min(low[d], chart(i, d)), high[d] = std::max(high[d], chart(i, d));
  for (Eigen::Index i = 0; i < chart.rows(); ++i)
    for (int d = 0; d < 2; ++d) chart(i, d) -= low[d];
  return {high[0] - low[0], high[1] - low[1]};
}

// Rectangles grown by the gap between charts; the square then loses one gap along its border. The gap is a
// fraction of the side that comes out, hence a few rounds.
double place(std::vector<Rectangle>& rectangles, double margin) {
  const std::vector<Rectangle> bare = rectangles;
  constexpr int most_rounds = 20;  // each brings the gap nearer to its fixed point, if there is one
  double gap = 0;
  for (int round = 0; round < most_rounds; ++round) {
    rectangles = bare;
    for (Rectangle& r : rectangles) r.width += gap, r.height += gap;
    const double side = place_in_square(rectangles) + gap;
    if (!(side > 0)) throw Error("pack: the charts have no extent");
    if (gap >= margin * side) {
      for (Rectangle& r : rectangles) r.x += gap, r.y += gap;
      return side;
    }
    gap = margin * side * 1.05;
  }
  throw Error("pack: a margin of " + to_text(margin) + " of the square leaves no room for " +
              std::to_string(rectangles.size()) + " charts");
}

}  // namespace

Packing pack(std::vector<mesh::Points2>& charts, const std::vector<mesh::Triangles>& triangles,
             const PackOptions& options) {
  require_packable(charts, triangles);
  if (!(options.margin >= 0) || options.margin > 0.25)
    throw Error("pack: the margin must be between 0 and 0.25");
  if (charts.empty()) return {};
  std::vector<Rectangle> rectangles;
  for (mesh::Points2& chart : charts) {
    if (options.rotate) lay_down(chart);
    rectangles.push_back(bounds(chart));
  }
  const double side = place(rectangles, options.margin);
  Packing packing;
  packing.scale = 1 / side;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    for (Eigen::Index i = 0; i < charts[c].rows(); ++i)
      charts[c].row(i) << (charts[c](i, 0) + rectangles[c].x) / side,
          (charts[c](i, 1) + rectangles[c].y) / side;
    packing.coverage += mesh::find_overlap(charts[c], triangles[c]).covered_area;
  }
  return packing;
}

}  // namespace isostretch::parameterization

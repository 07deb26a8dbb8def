
#include <isostretch/figures/layout_plot.hpp>
#include <isostretch/surface/edges.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace isostretch::figures {
namespace {

constexpr Eigen::Index few_triangles = 6000;  // more, and edges would hide the colours
constexpr std::size_t few_flips = 200;
constexpr Color hatch_color{0.05, 0.05, 0.05};

// uv to pixels: the layout centred in the box, v upwards.
class Fit {
 public:
  Fit(const LayoutData& data, const Box& box) {
    Eigen::RowVector2d low = data.uv.colwise().minCoeff(), high = data.uv.colwise().maxCoeff();
    if (data.unit_square) low = low.cwiseMin(0.0), high = high.cwiseMax(1.0);
    const Eigen::RowVector2d size = (high - low).cwiseMax(1e-300);
    scale_ = std::min(box.width / size.x(), box.height / size.y());
    center_ = 0.5 * (low + high);
    middle_ = {box.x + 0.5 * box.width, box.y + 0.5 * box.height};
  }
  Point operator()(const Eigen::RowVector2d& p) const {
    return {middle_.x + scale_ * (p.x() - center_.x()), middle_.y - scale_ * (p.y() - center_.y())};
  }

 private:
  double scale_;
  Eigen::RowVector2d center_;
  Point middle_;
};

// x and y of three corners in turn, in pixels of the raster.
struct Corners {
  double xy[6];
};

Corners corners_of(const LayoutData& data, const Fit& fit, const Box& box, Eigen::Index t) {
  Corners corners{};
  for (int c = 0; c < 3; ++c) {
    const Point p = fit(data.uv.row(data.triangles(t, c)));
    corners.xy[2 * c] = p.x - box.x;
    corners.xy[2 * c + 1] = p.y - box.y;
  }
  return corners;
}

Raster rasterize(const LayoutData& data, const Fit& fit, const Box& box, const DistortionScale& scale) {
  Raster raster(static_cast<int>(box.width), static_cast<int>(box.height));
  for (Eigen::Index t = 0; t < data.triangles.rows(); ++t)
    raster.fill_triangle(corners_of(data, fit, box, t).xy,
                         distortion_color(scale.color_value(data.distortions[static_cast<std::size_t>(t)])));
  for (const int t : data.flipped) raster.fill_triangle(corners_of(data, fit, box, t).xy, flipped_color);
  if (data.overlapping != nullptr)
    for (const int t : *data.overlapping)
      raster.hatch_triangle(corners_of(data, fit, box, t).xy, hatch_color);
  return raster;
}

void draw_edges(Canvas& canvas, const std::vector<std::array<int, 2>>& edges, const LayoutData& data,
                const Fit& fit, const LineStyle& style) {
  for (const auto& [a, b] : edges) canvas.line(fit(data.uv.row(a)), fit(data.uv.row(b)), style);
}

void draw_unit_square(Canvas& canvas, const Fit& fit) {
  const Point corner = fit({0, 1}), opposite = fit({1, 0});
  canvas.frame({corner.x, corner.y, opposite.x - corner.x, opposite.y - corner.y},
               {.color = {0.5, 0.5, 0.5}, .width = 1, .opacity = 0.7});
}

// Flipped triangles are often too small to be seen.
void circle_flips(Canvas& canvas, const LayoutData& data, const Fit& fit) {
  if (data.flipped.size() > few_flips) return;
  for (const int t : data.flipped) {
    Eigen::RowVector2d middle = Eigen::RowVector2d::Zero();
    for (int c = 0; c < 3; ++c) middle += data.uv.row(data.triangles(t, c)) / 3;
    canvas.ring(fit(middle), 6, {flipped_color, 2, 1});
  }
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, share < 0.095 ? "%.1f %%" : "%.0f %%", 100 * share);
  return text;
}

void draw_ticks(Canvas& canvas, const Box& bar, const DistortionScale& scale) {
  double lowest_free = HUGE_VAL;
  for (const Tick& tick : scale.axis.ticks) {
    const double y = bar.bottom() - bar.height * scale.axis.position(tick.value);
    if (y > lowest_free) continue;
    canvas.line({bar.x - 5, y}, {bar.x, y});
    canvas.text({bar.x - 8, y}, tick.label, {.size = 20, .across = Align::end});
    lowest_free = y - 24;
  }
  if (scale.above)
    canvas.text({bar.x + 0.5 * bar.width, bar.y - 12}, "▲", {.size = 16, .across = Align::middle});
}

}  // namespace

void draw_layout(Canvas& canvas, const Box& box, const LayoutData& data, const DistortionScale& scale) {
  if (data.uv.rows() == 0 || !data.uv.allFinite()) return;
  const Fit fit(data, {box.x + 2, box.y + 2, box.width - 4, box.height - 4});
  canvas.image(rasterize(data, fit, box, scale), {box.x, box.y});
  if (data.unit_square) draw_unit_square(canvas, fit);
  const mesh::Edges edges = mesh::edges_of(data.triangles);
  if (data.triangles.rows() <= few_triangles)
    draw_edges(canvas, edges.inner, data, fit, {.color = {0.1, 0.1, 0.1}, .width = 0.5, .opacity = 0.35});
  draw_edges(canvas, edges.boundary, data, fit, {.color = {0.1, 0.1, 0.1}, .width = 1, .opacity = 0.9});
  circle_flips(canvas, data, fit);
  for (const int v : data.pins) {
    canvas.dot(fit(data.uv.row(v)), 5, {1, 1, 1});
    canvas.dot(fit(data.uv.row(v)), 3.5, {0.1, 0.1, 0.1});
  }
}

void draw_distortion_scale(Canvas& canvas, const Box& box, const DistortionScale& scale,
                           const std::string& whole) {
  const Box bar{box.x + 60, box.y, 20, box.height};
  constexpr int steps = 256;
  for (int i = 0; i < steps; ++i) {
    const double top = std::round(bar.bottom() - bar.height * (i + 1) / steps);
    const double bottom = std::round(bar.bottom() - bar.height * i / steps);
    canvas.fill({bar.x, top, bar.width, bottom - top}, distortion_color((i + 0.5) / steps));
  }
  canvas.frame(bar, {.width = 0.8});
  draw_ticks(canvas, bar, scale);

  const double left = bar.right() + 4, room = box.right() - left;
  const double most = *std::max_element(scale.shares.begin(), scale.shares.end());
  const double step = bar.height / static_cast<double>(scale.shares.size());
  for (std::size_t i = 0; i < scale.shares.size(); ++i)
    canvas.fill({left, bar.bottom() - step * static_cast<double>(i + 1) + 0.5, room * scale.shares[i] / most,
                 step - 1},
                {0.55, 0.58, 0.62});
  canvas.text({box.right(), bar.bottom() + 20}, "longest: " + percent(most) + " of " + whole,
              {.size = 17, .color = {0.35, 0.35, 0.35}, .across = Align::end});
}

}  // namespace isostretch::figures

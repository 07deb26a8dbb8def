// Two plots over time: the energies, and the smallest determinants.
#include <isostretch/figures/interpolation_figure.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/figures/axis.hpp>
#include <isostretch/figures/canvas.hpp>

#include <algorithm>

namespace isostretch::figures {
namespace {

constexpr int width = 1600, height = 660;
constexpr LineStyle grid_style{{0.5, 0.5, 0.5}, 0.6, 0.35};
constexpr Color first_color{0.10, 0.36, 0.65}, second_color{0.80, 0.33, 0.05}, both_color{0.2, 0.2, 0.2};

struct Curve {
  std::string name;
  Color color;
  double InterpolationPoint::*value;
};

struct Plot {
  std::string title;
  std::vector<Curve> curves;
};

double largest(const InterpolationFigure& f, const std::vector<Curve>& curves) {
  double most = 0;
  for (const InterpolationPoint& point : f.points)
    for (const Curve& curve : curves) most = std::max(most, point.*curve.value);
  return most;
}

void draw_grid(Canvas& canvas, const Box& box, const Axis& x, const Axis& y) {
  for (const Tick& tick : x.ticks) {
    const double at = box.x + box.width * x.position(tick.value);
    canvas.line({at, box.y}, {at, box.bottom()}, grid_style);
    canvas.text({at, box.bottom() + 18}, tick.label, {.size = 19, .across = Align::middle});
  }
  for (const Tick& tick : y.ticks) {
    const double at = box.bottom() - box.height * y.position(tick.value);
    canvas.line({box.x, at}, {box.right(), at}, grid_style);
    canvas.text({box.x - 8, at}, tick.label, {.size = 19, .across = Align::end});
  }
  canvas.frame(box, {{0.3, 0.3, 0.3}, 0.8, 1});
}

// What lies beyond an axis, an inverted element's determinant, is drawn on its edge.
void draw_curve(Canvas& canvas, const Box& box, const Axis& x, const Axis& y, const InterpolationFigure& f,
                const Curve& curve) {
  std::vector<Point> points;
  for (const InterpolationPoint& point : f.points) {
    const double value = std::clamp(y.position(point.*curve.value), 0.0, 1.0);
    points.push_back({box.x + box.width * x.position(point.time), box.bottom() - box.height * value});
  }
  canvas.polyline(points, {curve.color, 2, 1});
  if (points.size() <= 60)
    for (const Point& p : points) canvas.dot(p, 3, curve.color);
}

void draw_legend(Canvas& canvas, Point at, const std::vector<Curve>& curves) {
  for (const Curve& curve : curves) {
    canvas.line(at, {at.x + 24, at.y}, {curve.color, 3, 1});
    canvas.text({at.x + 32, at.y}, curve.name, {.size = 20, .color = curve.color});
    at.x += 32 + canvas.text_width(curve.name, {.size = 20}) + 28;
  }
}

void draw_plot(Canvas& canvas, const Box& box, const InterpolationFigure& f, const Plot& plot) {
  const double most = largest(f, plot.curves);
  const Axis x = linear_axis(1, 6), y = linear_axis(most > 1e-200 ? most : 1, 6);
  canvas.text({box.x, box.y - 62}, plot.title, {.size = 24, .bold = true});
  draw_legend(canvas, {box.x, box.y - 24}, plot.curves);
  draw_grid(canvas, box, x, y);
  for (const Curve& curve : plot.curves) draw_curve(canvas, box, x, y, f, curve);
  canvas.text({box.x + 0.5 * box.width, box.bottom() + 48}, "t", {.size = 20, .across = Align::middle});
}

}  // namespace

std::string draw_energies(const InterpolationFigure& f) {
  constexpr double left = 100, gap = 130, top = 104, foot = 76, right = 32;
  const double plot_width = (width - left - gap - right) / 2, plot_height = height - top - foot;
  Canvas canvas(width, height);
  draw_plot(canvas, {left, top, plot_width, plot_height}, f,
            {"Energy above rest, " + f.energy_name,
             {{"ψ₁, from the first pose", first_color, &InterpolationPoint::psi_1},
              {"ψ₂, from the second", second_color, &InterpolationPoint::psi_2},
              {"(1 − t) ψ₁ + t ψ₂", both_color, &InterpolationPoint::energy}}});
  draw_plot(canvas, {left + plot_width + gap, top, plot_width, plot_height}, f,
            {"Smallest det F of a frame",
             {{"against the first pose", first_color, &InterpolationPoint::min_det_F_1},
              {"against the second", second_color, &InterpolationPoint::min_det_F_2}}});
  return canvas.file();
}

}  // namespace isostretch::figures

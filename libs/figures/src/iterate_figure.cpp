#include <isostretch/core/text.hpp>
#include <isostretch/figures/axis.hpp>
#include <isostretch/figures/deformed_views.hpp>
#include <isostretch/figures/iterate_figure.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::figures {
namespace {

constexpr int width = 1600;
constexpr double margin = 24, top = 118, gap = 12, inset = 12, caption = 96, most_view = 330,
                 plot_height = 240;
constexpr LineStyle grid_style{{0.5, 0.5, 0.5}, 0.6, 0.35};
constexpr Color inverted_color{0.0, 0.47, 0.62}, gap_color{0.80, 0.33, 0.05}, grey{0.3, 0.3, 0.3};

std::string gap_text(const IterateRow& row) {
  return row.feasible && row.gap > 0 ? formatted("gap %.1e", row.gap) : "no certificate yet";
}

void draw_captions(Canvas& canvas, Point at, const IterateRow& row) {
  const TextStyle bold{.size = 20, .bold = true, .across = Align::middle},
      plain{.size = 19, .color = grey, .across = Align::middle};
  canvas.text({at.x, at.y + 20}, formatted("iteration %d, %.3g s", row.iteration, row.seconds), bold);
  canvas.text(
      {at.x, at.y + 47}, row.inverted > 0 ? with_thousands(row.inverted) + " inverted" : "none inverted",
      row.inverted > 0 ? TextStyle{.size = 19, .color = inverted_color, .across = Align::middle} : plain);
  canvas.text({at.x, at.y + 73}, gap_text(row), plain);
}

struct Curve {
  std::string title;
  Color color;
  Axis axis;
  std::vector<double> values;  // one a row
  bool steps = false;          // zero is a value, too
};

void draw_grid(Canvas& canvas, const Box& box, const Axis& x, const Axis& y) {
  for (const Tick& tick : x.ticks) {
    const double at = box.x + box.width * x.position(tick.value);
    canvas.line({at, box.y}, {at, box.bottom()}, grid_style);
    canvas.text({at, box.bottom() + 18}, tick.label, {.size = 18, .across = Align::middle});
  }
  for (const Tick& tick : y.ticks) {
    const double at = box.bottom() - box.height * y.position(tick.value);
    canvas.line({box.x, at}, {box.right(), at}, grid_style);
    canvas.text({box.x - 8, at}, tick.label, {.size = 18, .across = Align::end});
  }
  canvas.frame(box, {grey, 0.8, 1});
}

void draw_curve(Canvas& canvas, const Box& box, const Axis& x, const std::vector<double>& seconds,
                const Curve& curve) {
  draw_grid(canvas, box, x, curve.axis);
  std::vector<Point> points;
  for (std::size_t i = 0; i < seconds.size(); ++i)
    if (curve.steps || curve.values[i] > 0)
      points.push_back(
          {box.x + box.width * x.position(seconds[i]),
           box.bottom() - box.height * std::clamp(curve.axis.position(curve.values[i]), 0.0, 1.0)});
  if (points.size() > 1) canvas.polyline(points, {curve.color, 2, 1});
  if (points.size() <= 80)
    for (const Point& p : points) canvas.dot(p, 3, curve.color);
  if (points.empty())
    canvas.text({box.x + 0.5 * box.width, box.y + 0.5 * box.height}, "no certificate",
                {.color = {0.5, 0.5, 0.5}, .across = Align::middle});
  canvas.text({box.x, box.y - 18}, curve.title, {.size = 20, .color = curve.color, .bold = true});
  canvas.text({box.x + 0.5 * box.width, box.bottom() + 44}, "seconds", {.size = 19, .across = Align::middle});
}

Curve inverted_curve(const std::vector<IterateRow>& trace) {
  Curve curve{"Inverted elements", inverted_color, {}, {}, true};
  double most = 1;
  for (const auto& row : trace) {
    curve.values.push_back(row.inverted);
    most = std::max(most, curve.values.back());
  }
  curve.axis = linear_axis(most, 5, true);
  return curve;
}

Curve gap_curve(const std::vector<IterateRow>& trace) {
  Curve curve{"Relative gap between energy and bound", gap_color, {}, {}, false};
  double low = 1, high = 1e-300;
  for (const auto& row : trace) {
    curve.values.push_back(row.iteration == 0 ? 0 : row.gap);
    if (!(curve.values.back() > 0)) continue;
    low = std::min(low, curve.values.back());
    high = std::max(high, curve.values.back());
  }
  curve.axis = decade_axis(std::min(low, 0.1), std::max(high, 0.1), 7);
  return curve;
}

void draw_plots(Canvas& canvas, double y, const std::vector<IterateRow>& trace) {
  constexpr double left = 96, between = 120;
  const double plot_width = (width - left - between - 2 * margin) / 2;
  std::vector<double> seconds;
  for (const auto& row : trace) seconds.push_back(row.seconds);
  const Axis x = linear_axis(std::max(seconds.empty() ? 0.0 : seconds.back(), 1e-6), 6);
  draw_curve(canvas, {left, y, plot_width, plot_height}, x, seconds, inverted_curve(trace));
  draw_curve(canvas, {left + plot_width + between, y, plot_width, plot_height}, x, seconds, gap_curve(trace));
}

}  // namespace

double relative_gap(double energy, double lower_bound) {
  const double scale = std::max({std::abs(energy), std::abs(lower_bound), 1e-300});
  const double value = (energy - lower_bound) / scale;
  return std::isfinite(value) && value > 0 ? value : 0;
}

std::string draw_iterates(const DeformationFigure& figure, const std::vector<IterateRow>& shown,
                          const std::vector<IterateRow>& trace) {
  const int view_width = static_cast<int>((width - 2 * margin - (shown_iterates - 1) * gap) / shown_iterates);
  const DeformedViews views(figure, view_width, most_view, inset);
  const int view_height = static_cast<int>(std::ceil(views.height()));
  const double plots = top + view_height + caption + 56;
  Canvas canvas(width, static_cast<int>(plots + plot_height + 68));
  const DistortionScale scale = distortion_scale(figure.states.back().length_change, figure.volumes, 56, 1);
  canvas.text({margin, 38}, canvas.shortened(figure.title, width - 2 * margin, {.size = 32, .bold = true}),
              {.size = 32, .bold = true});
  canvas.text({margin, 82}, figure.subtitle, {.size = 22, .color = grey});
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Point corner{margin + static_cast<double>(i) * (view_width + gap), top};
    views.draw(canvas, i, corner, view_height, scale);
    draw_captions(canvas, {corner.x + 0.5 * view_width, top + view_height + 2}, shown[i]);
  }
  draw_plots(canvas, plots, trace);
  return canvas.file();
}

}  // namespace isostretch::figures

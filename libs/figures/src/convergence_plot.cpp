
#include <isostretch/figures/axis.hpp>
#include <isostretch/figures/convergence_plot.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace isostretch::figures {
namespace {

constexpr LineStyle grid_style{{0.5, 0.5, 0.5}, 0.6, 0.35};

struct Series {
  std::string name;
  Color color;
  std::vector<double> values;   // one per row of the trace; those that are not positive are left out
  std::vector<int> piece = {};  // of every row, where the curve is broken between pieces
};

std::vector<double> energy_above_best(const std::vector<newton::Iteration>& trace) {
  double best = HUGE_VAL;
  for (const auto& row : trace) best = std::min(best, row.energy);
  std::vector<double> values;
  for (const auto& row : trace) values.push_back(row.energy - best);
  return values;
}

std::vector<double> gradient_norms(const std::vector<newton::Iteration>& trace) {
  std::vector<double> values;
  for (const auto& row : trace) values.push_back(row.gradient_inf_norm);
  return values;
}

bool shown(double value) {
  return value > 0 && std::isfinite(value);
}

Axis axis_of(const Series& series) {
  double low = HUGE_VAL, high = 0;
  for (const double value : series.values) {
    if (!shown(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return high > 0 ? decade_axis(low, high, 9) : decade_axis(0.1, 1, 2);
}

void draw_horizontal_ticks(Canvas& canvas, const Box& box, const Axis& axis, bool labels) {
  for (const Tick& tick : axis.ticks) {
    const double x = box.x + box.width * axis.position(tick.value);
    canvas.line({x, box.y}, {x, box.bottom()}, grid_style);
    if (labels) canvas.text({x, box.bottom() + 18}, tick.label, {.size = 20, .across = Align::middle});
  }
}

void draw_vertical_ticks(Canvas& canvas, const Box& box, const Axis& axis, bool labels) {
  for (const Tick& tick : axis.ticks) {
    const double y = box.bottom() - box.height * axis.position(tick.value);
    if (!tick.label.empty()) canvas.line({box.x, y}, {box.right(), y}, grid_style);
    if (labels) canvas.text({box.x - 8, y}, tick.label, {.size = 20, .across = Align::end});
  }
}

void draw_pieces(Canvas& canvas, const std::vector<Point>& points, const std::vector<int>& piece,
                 const LineStyle& style) {
  for (std::size_t i = 0, next = 0; i < points.size(); i = next) {
    while (next < points.size() && piece[next] == piece[i]) ++next;
    const auto first = points.begin();
    canvas.polyline({first + static_cast<std::ptrdiff_t>(i), first + static_cast<std::ptrdiff_t>(next)},
                    style);
  }
}

void draw_curve(Canvas& canvas, const Box& box, const Axis& x_axis, const std::vector<double>& x,
                const Axis& y_axis, const Series& series) {
  std::vector<Point> points;
  std::vector<int> piece;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!shown(series.values[i])) continue;
    points.push_back({box.x + box.width * x_axis.position(x[i]),
                      box.bottom() - box.height * y_axis.position(series.values[i])});
    piece.push_back(series.piece.empty() ? 0 : series.piece[i]);
  }
  const bool many = points.size() > 200;  // dots would run together
  draw_pieces(canvas, points, piece, {series.color, many ? 1.0 : 2.0, 1});
  const double radius = many ? 0.5 : points.size() > 60 ? 1.8 : 3;
  for (const Point& p : points) canvas.dot(p, radius, series.color);
  if (points.empty())
    canvas.text({box.x + 0.5 * box.width, box.y + 0.5 * box.height}, "nothing above zero",
                {.size = 20, .color = {0.5, 0.5, 0.5}, .across = Align::middle});
}

}  // namespace

void draw_convergence(Canvas& canvas, const Box& box, const std::vector<newton::Iteration>& trace,
                      const std::vector<int>& chart_of_row) {
  if (trace.empty()) {
    canvas.text({box.x + 0.5 * box.width, box.y + 0.5 * box.height}, "no iterations",
                {.across = Align::middle});
    return;
  }
  std::vector<double> iterations;
  for (const auto& row : trace) iterations.push_back(row.iteration);
  const Axis x_axis = linear_axis(iterations.back(), 6, true);
  const Series series[] = {{"energy − best", {0.10, 0.36, 0.65}, energy_above_best(trace)},
                           {"|gradient|∞", {0.80, 0.33, 0.05}, gradient_norms(trace), chart_of_row}};

  constexpr double left = 72, title = 32, foot = 62, between = 16;
  const double height = (box.height - 2 * title - foot - between) / 2;
  for (int r = 0; r < 2; ++r) {
    const Axis y_axis = axis_of(series[r]);
    const Box plot{box.x + left, box.y + title + r * (height + title + between), box.width - left, height};
    draw_horizontal_ticks(canvas, plot, x_axis, r == 1);
    draw_vertical_ticks(canvas, plot, y_axis, true);
    canvas.frame(plot, {{0.3, 0.3, 0.3}, 0.8, 1});
    draw_curve(canvas, plot, x_axis, iterations, y_axis, series[r]);
    canvas.text({plot.x, plot.y - 15}, series[r].name, {.size = 21, .color = series[r].color, .bold = true});
    if (r == 1)
      canvas.text({plot.x + 0.5 * plot.width, plot.bottom() + 46}, "iterations",
                  {.size = 20, .across = Align::middle});
  }
}

}  // namespace isostretch::figures

#include "common/figures/comparison_plot.hpp"

#include "common/figures/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isostretch::app::figures {
namespace {

constexpr double margin = 24, left = 76, below = 62, above = 36, legend_width = 230, top = 84;
constexpr double panel_width = 560, panel_height = 300;
constexpr LineStyle grid_style{{0.5, 0.5, 0.5}, 0.6, 0.3};
constexpr Color grey{0.3, 0.3, 0.3};

// Ten hues, then the same ones pale.
Color curve_color(std::size_t i) {
  constexpr std::array<Color, 10> hues{{{0.12, 0.12, 0.12},
                                        {0.84, 0.15, 0.16},
                                        {0.12, 0.47, 0.71},
                                        {0.17, 0.63, 0.17},
                                        {1.00, 0.50, 0.05},
                                        {0.58, 0.40, 0.74},
                                        {0.55, 0.34, 0.29},
                                        {0.89, 0.47, 0.76},
                                        {0.09, 0.75, 0.81},
                                        {0.74, 0.74, 0.13}}};
  Color color = hues[i % hues.size()];
  const double pale = std::min(0.6, 0.45 * static_cast<double>(i / hues.size()));
  for (double* part : {&color.r, &color.g, &color.b}) *part += pale * (1 - *part);
  return color;
}

Axis axis_over(const ComparisonPanel& panel, double Point::*part, bool logarithmic, int most_ticks) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const auto& curve : panel.curves)
    for (const Point& p : curve)
      if (std::isfinite(p.*part) && (!logarithmic || p.*part > 0)) {
        low = std::min(low, p.*part);
        high = std::max(high, p.*part);
      }
  if (!logarithmic) return linear_axis(std::max(high, 1.0), most_ticks, true);
  if (!(high > 0)) low = high = 1;
  return decade_axis(std::max(low, high * 1e-18), high, most_ticks);
}

double place(const Axis& axis, double value) {
  if (axis.logarithmic && !(value > axis.low)) return 0;
  return std::clamp(axis.position(value), 0.0, 1.0);
}

void draw_axes(Canvas& canvas, const Box& box, const Axis& x, const Axis& y, const ComparisonPanel& panel) {
  for (const Tick& tick : x.ticks) {
    const double at = box.x + box.width * x.position(tick.value);
    canvas.line({at, box.y}, {at, box.bottom()}, grid_style);
    canvas.text({at, box.bottom() + 15}, tick.label, {.size = 12, .across = Align::middle});
  }
  for (const Tick& tick : y.ticks) {
    const double at = box.bottom() - box.height * y.position(tick.value);
    canvas.line({box.x, at}, {box.right(), at}, grid_style);
    canvas.text({box.x - 8, at}, tick.label, {.size = 12, .across = Align::end});
  }
  canvas.frame(box, {grey, 0.8, 1});
  canvas.text({box.x, box.y - 15}, panel.title, {.size = 14, .bold = true});
  canvas.text({box.x + 0.5 * box.width, box.bottom() + 36}, panel.x_label, {.across = Align::middle});
}

void draw_panel(Canvas& canvas, const Box& box, const ComparisonPanel& panel) {
  const Axis x = axis_over(panel, &Point::x, panel.logarithmic_x, 7),
             y = axis_over(panel, &Point::y, panel.logarithmic_y, 8);
  draw_axes(canvas, box, x, y, panel);
  // The first is drawn last, on top.
  for (std::size_t i = panel.curves.size(); i-- > 0;) {
    std::vector<Point> line;
    for (const Point& p : panel.curves[i])
      if (std::isfinite(p.x) && std::isfinite(p.y))
        line.push_back({box.x + box.width * place(x, p.x), box.bottom() - box.height * place(y, p.y)});
    const Color color = curve_color(i);
    if (line.size() > 1) canvas.polyline(line, {color, i == 0 ? 3.0 : 1.8, 1});
    if (!line.empty()) canvas.ring(line.back(), 4, {color, 2, 1});
  }
}

}  // namespace

std::string draw_comparison(const std::string& title, const std::string& subtitle,
                            const std::vector<std::string>& names, const std::vector<ComparisonPanel>& panels,
                            int columns) {
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const double across = left + panel_width + margin, down = above + panel_height + below;
  const double legend_height = static_cast<double>(names.size()) * 22;
  const double height = top + std::max(rows * down, legend_height + above);
  Canvas canvas(static_cast<int>(columns * across + legend_width), static_cast<int>(height));
  canvas.text({margin, 30}, title, {.size = 20, .bold = true});
  canvas.text({margin, 58}, subtitle, {.size = 14, .color = grey});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int row = static_cast<int>(i) / columns, column = static_cast<int>(i) % columns;
    draw_panel(canvas, {column * across + left, top + row * down + above, panel_width, panel_height},
               panels[i]);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Point at{columns * across + 10, top + above + 10 + 22 * static_cast<double>(i)};
    canvas.line(at, {at.x + 26, at.y}, {curve_color(i), i == 0 ? 3.0 : 1.8, 1});
    canvas.ring({at.x + 26, at.y}, 4, {curve_color(i), 2, 1});
    canvas.text({at.x + 38, at.y}, names[i], {.size = 13});
  }
  return canvas.png();
}

}  // namespace isostretch::app::figures

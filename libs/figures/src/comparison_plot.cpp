
#include <isostretch/figures/axis.hpp>
#include <isostretch/figures/comparison_plot.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isostretch::figures {
namespace {

constexpr double margin = 24, left = 96, below = 74, above = 44, top = 100;
constexpr double panel_width = 560, panel_height = 300;
constexpr LineStyle grid_style{{0.5, 0.5, 0.5}, 0.6, 0.3};
constexpr Color grey{0.3, 0.3, 0.3};

struct CurveStyle {
  LineStyle line;
  int mark = 0;  // the number of its shape
};

// Ten hues, dashed otherwise where they come again, and marks that come again later still.
CurveStyle curve_style(std::size_t i) {
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
  constexpr std::array<Dash, 4> dashes{Dash::solid, Dash::dashed, Dash::dotted, Dash::dash_dotted};
  const std::size_t round = i / hues.size();
  return {{hues[i % hues.size()], i == 0 ? 3.0 : 1.8, 1, dashes[round % dashes.size()]},
          static_cast<int>((i + round) % 5)};
}

void draw_mark(Canvas& canvas, Point at, const CurveStyle& style) {
  constexpr double r = 4;
  const double x = at.x, y = at.y;
  switch (style.mark) {
    case 0:
      return canvas.dot(at, 0.9 * r, style.line.color);
    case 1:
      return canvas.polygon({{x - r, y + 0.7 * r}, {x + r, y + 0.7 * r}, {x, y - r}}, style.line.color);
    case 2:
      return canvas.fill({x - 0.8 * r, y - 0.8 * r, 1.6 * r, 1.6 * r}, style.line.color);
    case 3:
      return canvas.polygon({{x - r, y}, {x, y + r}, {x + r, y}, {x, y - r}}, style.line.color);
    default:
      return canvas.polygon({{x - r, y - 0.7 * r}, {x + r, y - 0.7 * r}, {x, y + r}}, style.line.color);
  }
}

Axis axis_over(const ComparisonPanel& panel, double Point::*part, bool logarithmic, int most_ticks) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const auto& curve : panel.curves)
    for (const Point& p : curve)
      if (std::isfinite(p.*part) && (!logarithmic || p.*part > 0)) {
        low = std::min(low, p.*part);
        high = std::max(high, p.*part);
      }
  if (!logarithmic) return linear_axis(std::max(high, 1.0), most_ticks, panel.counts);
  if (!(high > 0)) low = high = 1;
  if (part == &Point::x && high > low) return narrow_log_axis(low / 1.1, high * 1.1, most_ticks);
  return decade_axis(std::max({low, high * 1e-18, std::min(panel.lowest_y, high)}), high, most_ticks);
}

double place(const Axis& axis, double value) {
  if (axis.logarithmic && !(value > axis.low)) return 0;
  return std::clamp(axis.position(value), 0.0, 1.0);
}

void draw_axes(Canvas& canvas, const Box& box, const Axis& x, const Axis& y, const ComparisonPanel& panel) {
  for (const Tick& tick : x.ticks) {
    const double at = box.x + box.width * x.position(tick.value);
    canvas.line({at, box.y}, {at, box.bottom()}, grid_style);
    canvas.text({at, box.bottom() + 18}, tick.label, {.size = 17, .across = Align::middle});
  }
  for (const Tick& tick : y.ticks) {
    const double at = box.bottom() - box.height * y.position(tick.value);
    canvas.line({box.x, at}, {box.right(), at}, grid_style);
    canvas.text({box.x - 8, at}, tick.label, {.size = 17, .across = Align::end});
  }
  for (const double level : panel.levels) {
    const double at = box.bottom() - box.height * place(y, level);
    canvas.line({box.x, at}, {box.right(), at}, {grey, 1, 0.8, Dash::dashed});
  }
  canvas.frame(box, {grey, 0.8, 1});
  canvas.text({box.x, box.y - 18}, panel.title, {.size = 20, .bold = true});
  canvas.text({box.x + 0.5 * box.width, box.bottom() + 44}, panel.x_label,
              {.size = 18, .across = Align::middle});
}

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// Of points closer together than what can be seen the last one is kept.
std::vector<Point> visible_line(const std::vector<Point>& curve, const Box& box, const Axis& x,
                                const Axis& y) {
  std::vector<Point> line;
  Point anchor;  // the first of those that the last point stands for
  for (const Point& p : curve) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    const Point at{box.x + box.width * place(x, p.x), box.bottom() - box.height * place(y, p.y)};
    if (line.size() > 1 && distance(anchor, at) < 0.4)
      line.back() = at;
    else
      line.push_back(anchor = at);
  }
  return line;
}

// A mark now and then, where the curve has left the last one behind.
void draw_marks(Canvas& canvas, const std::vector<Point>& line, const CurveStyle& style) {
  constexpr double apart = 45;
  for (std::size_t k = 1, last = 0; k + 1 < line.size(); ++k) {
    if (distance(line[last], line[k]) < apart) continue;
    draw_mark(canvas, line[k], style);
    last = k;
  }
}

void draw_panel(Canvas& canvas, const Box& box, const ComparisonPanel& panel) {
  const Axis x = axis_over(panel, &Point::x, panel.logarithmic_x, 7),
             y = axis_over(panel, &Point::y, panel.logarithmic_y, 8);
  draw_axes(canvas, box, x, y, panel);
  // The first is drawn last, on top.
  for (std::size_t i = panel.curves.size(); i-- > 0;) {
    const std::vector<Point> line = visible_line(panel.curves[i], box, x, y);
    const CurveStyle style = curve_style(i);
    if (line.size() > 1) canvas.polyline(line, style.line);
    draw_marks(canvas, line, style);
    if (!line.empty()) canvas.ring(line.back(), 4, {style.line.color, 2, 1});
  }
}

// Besides the names, which take what they need.
constexpr double legend_margin = 84, legend_line = 27;

double legend_width(const std::vector<std::string>& names) {
  Canvas measure(1, 1);
  double widest = 0;
  for (const std::string& name : names) widest = std::max(widest, measure.text_width(name, {.size = 18}));
  return legend_margin + widest;
}

void draw_legend(Canvas& canvas, Point corner, const std::vector<std::string>& names) {
  Point at = corner;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) continue;
    const CurveStyle style = curve_style(i);
    canvas.line(at, {at.x + 40, at.y}, style.line);
    draw_mark(canvas, {at.x + 20, at.y}, style);
    canvas.text({at.x + 50, at.y}, names[i], {.size = 18});
    at.y += legend_line;
  }
}

}  // namespace

std::string draw_comparison(const std::string& title, const std::string& subtitle,
                            const std::vector<std::string>& names, const std::vector<ComparisonPanel>& panels,
                            int columns, PictureFormat format) {
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const double across = left + panel_width + margin, down = above + panel_height + below;
  const double legend_height = static_cast<double>(names.size()) * legend_line;
  const double height = top + std::max(rows * down, legend_height + above);
  Canvas canvas(static_cast<int>(columns * across + legend_width(names)), static_cast<int>(height), format);
  canvas.text({margin, 36}, title, {.size = 29, .bold = true});
  canvas.text({margin, 72}, subtitle, {.size = 20, .color = grey});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int row = static_cast<int>(i) / columns, column = static_cast<int>(i) % columns;
    draw_panel(canvas, {column * across + left, top + row * down + above, panel_width, panel_height},
               panels[i]);
  }
  draw_legend(canvas, {columns * across + 10, top + above + 10}, names);
  return canvas.file();
}

}  // namespace isostretch::figures

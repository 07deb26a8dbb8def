
#include <isostretch/figures/scan_triangle.hpp>
#include <isostretch/figures/visibility.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::figures {
namespace {

ScreenPoint between(const ScreenPoint& a, const ScreenPoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.nearness + t * (b.nearness - a.nearness)};
}

// Nearness of a triangle over the screen.
struct Plane {
  double at_origin = 0, along_x = 0, along_y = 0, low = 0, high = 0;

  Plane(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    const double db = b.nearness - a.nearness, dc = c.nearness - a.nearness;
    along_x = (db * (c.y - a.y) - dc * (b.y - a.y)) / area;
    along_y = (dc * (b.x - a.x) - db * (c.x - a.x)) / area;
    at_origin = a.nearness - along_x * a.x - along_y * a.y;
    low = std::min({a.nearness, b.nearness, c.nearness});
    high = std::max({a.nearness, b.nearness, c.nearness});
  }
  // Rounding of a sliver, seen edge on, must not carry it away.
  float operator()(double x, double y) const {
    return static_cast<float>(std::max(low, std::min(high, at_origin + along_x * x + along_y * y)));
  }
};

}  // namespace

Visibility::Visibility(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      number_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), nothing),
      nearness_(number_.size(), 0.0F) {}

void Visibility::add_triangle(int number, const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  const Plane plane(a, b, c);
  scan_triangle({a.x, a.y, b.x, b.y, c.x, c.y}, columns_, rows_, [&](int row, int from, int to) {
    for (int column = from; column < to; ++column) {
      const float nearness = plane(column + 0.5, row + 0.5);
      const std::size_t i = index(column, row);
      if (!(nearness > nearness_[i])) continue;
      nearness_[i] = nearness;
      number_[i] = number;
    }
  });
}

// In pieces, so that the box around each holds little else.
void Visibility::add_line(const ScreenPoint& a, const ScreenPoint& b, double width, double slack) {
  const int pieces = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / 16);
  for (int i = 0; i < pieces; ++i)
    add_short_line(between(a, b, static_cast<double>(i) / pieces), between(a, b, (i + 1.0) / pieces), width,
                   slack);
}

void Visibility::add_short_line(const ScreenPoint& a, const ScreenPoint& b, double width, double slack) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = std::max(dx * dx + dy * dy, 1e-12),
               half = 0.5 * width;
  const int first_row = first_sample(std::min(a.y, b.y) - half, rows_);
  const int last_row = first_sample(std::max(a.y, b.y) + half, rows_);
  const int first = first_sample(std::min(a.x, b.x) - half, columns_);
  const int last = first_sample(std::max(a.x, b.x) + half, columns_);
  for (int row = first_row; row < last_row; ++row)
    for (int column = first; column < last; ++column) {
      const double x = column + 0.5, y = row + 0.5;
      const double t = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / squared, 0.0, 1.0);
      const ScreenPoint p = between(a, b, t);
      const std::size_t i = index(column, row);
      if (std::hypot(x - p.x, y - p.y) <= half &&
          p.nearness * (1 + slack) >= static_cast<double>(nearness_[i]))
        number_[i] = line;
    }
}

bool Visibility::sees(const ScreenPoint& p, double slack) const {
  const int column = std::min(first_sample(p.x, columns_), columns_ - 1);
  const int row = std::min(first_sample(p.y, rows_), rows_ - 1);
  return p.nearness * (1 + slack) >= static_cast<double>(nearness_[index(column, row)]);
}

}  // namespace isostretch::figures

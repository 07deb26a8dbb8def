#include "enclosing_rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace isostretch::parameterization {
namespace {

struct Point {
  double x, y;
};

double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Counter-clockwise, without repetition (Andrew's monotone chain).
std::vector<Point> convex_hull(const mesh::Points2& points) {
  std::vector<Point> sorted;
  for (Eigen::Index i = 0; i < points.rows(); ++i) sorted.push_back({points(i, 0), points(i, 1)});
  std::sort(sorted.begin(), sorted.end(),
            [](const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Point> hull;
  const auto chain = [&hull](const auto begin, const auto end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    if (!hull.empty()) hull.pop_back();  // the other chain begins with it
  };
  chain(sorted.begin(), sorted.end());
  chain(sorted.rbegin(), sorted.rend());
  return hull;
}

struct Extent {
  double along = 0, across = 0;
};

Extent extent(const std::vector<Point>& hull, const Direction& d) {
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (const Point& p : hull) {
    const double value[2] = {d.x * p.x + d.y * p.y, d.x * p.y - d.y * p.x};
    for (int i = 0; i < 2; ++i) low[i] = std::min(low[i], value[i]), high[i] = std::max(high[i], value[i]);
  }
  return {high[0] - low[0], high[1] - low[1]};
}

// Hulls of charts have few sides; of those with more, an even sample is as good as all.
constexpr std::size_t most_sides = 512;

}  // namespace

Direction smallest_rectangle(const mesh::Points2& points) {
  const std::vector<Point> hull = convex_hull(points);
  Direction best;
  double smallest = std::numeric_limits<double>::infinity();
  const std::size_t step = 1 + hull.size() / most_sides;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const Point &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double size = std::hypot(b.x - a.x, b.y - a.y);
    if (!(size > 0)) continue;
    Direction d{(b.x - a.x) / size, (b.y - a.y) / size};
    const Extent e = extent(hull, d);
    if (e.along * e.across >= smallest) continue;
    smallest = e.along * e.across;
    best = e.along >= e.across ? d : Direction{-d.y, d.x};
  }
  return best;
}

}  // namespace isostretch::parameterization

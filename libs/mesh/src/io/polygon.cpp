#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isostretch::mesh {
namespace {

struct Point {
  double x = 0, y = 0;

  bool operator==(const Point& other) const { return x == other.x && y == other.y; }
};

double doubled_area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double squared_distance(const Point& a, const Point& b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

// Height over longest edge; below this a triangle counts for none.
constexpr double flat = 1e-12;

double quality(const Point& a, const Point& b, const Point& c) {
  const double longest = std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  return longest > 0 ? doubled_area(a, b, c) / longest : 0;
}

// In the plane of the polygon's area vector (Newell), counter-clockwise; relative to the first corner and the
// size, so that neither place nor scale matters.
std::vector<Point> flattened(const std::vector<std::array<double, 3>>& polygon) {
  double size = 0;
  for (const auto& p : polygon)
    for (std::size_t i = 0; i < 3; ++i) size = std::max(size, std::abs(p[i] - polygon[0][i]));
  if (!(size > 0) || !std::isfinite(size)) return {};
  const auto at = [&](std::size_t corner, std::size_t axis) {
    return (polygon[corner % polygon.size()][axis] - polygon[0][axis]) / size;
  };
  std::array<double, 3> normal{};
  for (std::size_t c = 0; c < polygon.size(); ++c)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      normal[i] += at(c, j) * at(c + 1, k) - at(c, k) * at(c + 1, j);
    }
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (!(length > flat)) return {};
  for (double& n : normal) n /= length;
  // A direction in the plane: the axis farthest from the normal, made perpendicular.
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(normal[i]) < std::abs(normal[axis])) axis = i;
  std::array<double, 3> u{};
  u[axis] = 1;
  for (std::size_t i = 0; i < 3; ++i) u[i] -= normal[axis] * normal[i];
  const double scale = std::hypot(u[0], u[1], u[2]);
  for (double& x : u) x /= scale;
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = normal[(i + 1) % 3] * u[(i + 2) % 3] - normal[(i + 2) % 3] * u[(i + 1) % 3];
  std::vector<Point> points;
  for (std::size_t c = 0; c < polygon.size(); ++c)
    points.push_back({at(c, 0) * u[0] + at(c, 1) * u[1] + at(c, 2) * u[2],
                      at(c, 0) * v[0] + at(c, 1) * v[1] + at(c, 2) * v[2]});
  return points;
}

std::vector<int> cut_quad(const std::vector<Point>& p) {
  const double first = std::min(quality(p[0], p[1], p[2]), quality(p[0], p[2], p[3]));
  const double second = std::min(quality(p[0], p[1], p[3]), quality(p[1], p[2], p[3]));
  constexpr double equal = 1e-9;  // of equally good ones the diagonal of the first corner
  if (std::max(first, second) <= flat) return {};
  if (first >= second - equal && first > flat) return {0, 1, 2, 0, 2, 3};
  return {0, 1, 3, 1, 2, 3};
}

// Cuts off one ear after the other.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<Point>& points) : p_(points) {
    for (std::size_t c = 0; c < points.size(); ++c) left_.push_back(static_cast<int>(c));
  }

  std::vector<int> run() {
    while (left_.size() > 3) {
      const std::size_t ear = next_ear();
      if (ear == left_.size()) return {};
      append(ear);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
      start_ = ear;
    }
    if (ear_quality(0) <= flat) return {};
    triangles_.insert(triangles_.end(), left_.begin(), left_.end());
    return std::move(triangles_);
  }

 private:
  // The best ear costs the square of the corners for every one; with many, the next one has to do.
  static constexpr std::size_t many = 64;

  std::size_t next_ear() const {
    std::size_t best = left_.size();
    double best_quality = flat;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const std::size_t c = (start_ + i) % left_.size();
      const double own = ear_quality(c);
      // Later ones have to be better by more than rounding.
      if (!(own > best_quality * (1 + 1e-9)) || !is_empty(c)) continue;
      best = c, best_quality = own;
      if (left_.size() > many) break;
    }
    return best;
  }

  std::size_t before(std::size_t c) const { return (c + left_.size() - 1) % left_.size(); }
  std::size_t after(std::size_t c) const { return (c + 1) % left_.size(); }
  const Point& at(std::size_t c) const { return p_[static_cast<std::size_t>(left_[c])]; }
  double ear_quality(std::size_t c) const { return quality(at(before(c)), at(c), at(after(c))); }

  // No other corner lies in the ear or on its edges. Corners at the place of one of the ear's are no
  // obstacle: polygons with holes run along a bridge twice.
  bool is_empty(std::size_t ear) const {
    const Point &a = at(before(ear)), &b = at(ear), &c = at(after(ear));
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const Point& q = at(i);
      if (q == a || q == b || q == c) continue;
      if (doubled_area(a, b, q) >= -flat && doubled_area(b, c, q) >= -flat && doubled_area(c, a, q) >= -flat)
        return false;
    }
    return true;
  }

  void append(std::size_t ear) {
    for (const std::size_t c : {before(ear), ear, after(ear)}) triangles_.push_back(left_[c]);
  }

  const std::vector<Point>& p_;
  std::vector<int> left_;  // corners not cut off yet
  std::vector<int> triangles_;
  std::size_t start_ = 0;
};

}  // namespace

std::vector<int> triangulated(const std::vector<std::array<double, 3>>& polygon) {
  if (polygon.size() < 3) return {};
  const std::vector<Point> points = flattened(polygon);
  if (points.empty()) return {};
  return points.size() == 4 ? cut_quad(points) : EarClipper(points).run();
}

}  // namespace isostretch::mesh

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

// Height over longest edge; below this a triangle counts for none. Distances over the polygon's size below
// it are rounding.
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

// Corners by where they lie, in square cells, of which there are about as many as corners.
class Cells {
 public:
  explicit Cells(const std::vector<Point>& points) {
    low_ = high_ = points.front();
    for (const Point& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    const double width = high_.x - low_.x, height = high_.y - low_.y;
    const double count = static_cast<double>(points.size());
    side_ = std::max(std::sqrt(width * height / count), std::max(width, height) / count);
    columns_ = column(high_.x) + 1;
    corners_.resize(columns_ * (row(high_.y) + 1));
    for (std::size_t c = 0; c < points.size(); ++c) cell(points[c]).push_back(static_cast<int>(c));
  }

  void remove(int corner, const Point& p) {
    std::vector<int>& here = cell(p);
    here.erase(std::find(here.begin(), here.end(), corner));
  }

  // Whether one of those in the cells that meet the box is as asked for.
  template <class Predicate>
  bool any_of(const Point& low, const Point& high, const Predicate& predicate) const {
    for (std::size_t r = row(low.y); r <= row(high.y); ++r)
      for (std::size_t c = column(low.x); c <= column(high.x); ++c)
        if (std::any_of(corners_[r * columns_ + c].begin(), corners_[r * columns_ + c].end(), predicate))
          return true;
    return false;
  }

 private:
  std::size_t column(double x) const {
    return static_cast<std::size_t>((std::clamp(x, low_.x, high_.x) - low_.x) / side_);
  }
  std::size_t row(double y) const {
    return static_cast<std::size_t>((std::clamp(y, low_.y, high_.y) - low_.y) / side_);
  }
  std::vector<int>& cell(const Point& p) { return corners_[row(p.y) * columns_ + column(p.x)]; }

  Point low_, high_;
  double side_ = 0;
  std::size_t columns_ = 0;
  std::vector<std::vector<int>> corners_;
};

// Cuts off one ear after the other.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<Point>& points) : p_(points), cells_(points) {
    const int count = static_cast<int>(points.size());
    for (int c = 0; c < count; ++c) {
      before_.push_back((c + count - 1) % count);
      after_.push_back((c + 1) % count);
    }
    left_ = points.size();
  }

  std::vector<int> run() {
    while (left_ > 3) {
      const int ear = next_ear();
      if (ear < 0) return {};
      cut_off(ear);
    }
    if (ear_quality(start_) <= flat) return {};
    append(after(std::min({before(start_), start_, after(start_)})));
    return std::move(triangles_);
  }

 private:
  // The best ear costs the square of the corners for every one; with many, the next one has to do.
  static constexpr std::size_t many = 64;

  int next_ear() const {
    int best = -1, c = start_;
    double best_quality = flat;
    for (std::size_t i = 0; i < left_; ++i, c = after(c)) {
      const double own = ear_quality(c);
      // Later ones have to be better by more than rounding.
      if (!(own > best_quality * (1 + 1e-9)) || !is_empty(c)) continue;
      best = c, best_quality = own;
      if (left_ > many) break;
    }
    return best;
  }

  void cut_off(int ear) {
    append(ear);
    cells_.remove(ear, at(ear));
    start_ = after(ear);
    after_[index(before(ear))] = after(ear);
    before_[index(after(ear))] = before(ear);
    --left_;
  }

  static std::size_t index(int c) { return static_cast<std::size_t>(c); }
  int before(int c) const { return before_[index(c)]; }
  int after(int c) const { return after_[index(c)]; }
  const Point& at(int c) const { return p_[index(c)]; }
  double ear_quality(int c) const { return quality(at(before(c)), at(c), at(after(c))); }

  // No other corner lies in the ear or on its edges. Corners at the place of one of the ear's are no
  // obstacle: polygons with holes run along a bridge twice.
  bool is_empty(int ear) const {
    const Point &a = at(before(ear)), &b = at(ear), &c = at(after(ear));
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [lower, upper] = std::minmax({a.y, b.y, c.y});
    // What lies beside an edge by less than rounding counts as on it.
    const double ab = flat * std::sqrt(squared_distance(a, b)), bc = flat * std::sqrt(squared_distance(b, c)),
                 ca = flat * std::sqrt(squared_distance(c, a));
    const double beyond = 3 * std::max({ab, bc, ca}) / doubled_area(a, b, c);
    const double x = beyond * (right - left), y = beyond * (upper - lower);
    return !cells_.any_of({left - x, lower - y}, {right + x, upper + y}, [&](int other) {
      const Point& q = at(other);
      if (q == a || q == b || q == c) return false;
      return doubled_area(a, b, q) >= -ab && doubled_area(b, c, q) >= -bc && doubled_area(c, a, q) >= -ca;
    });
  }

  void append(int ear) {
    for (const int c : {before(ear), ear, after(ear)}) triangles_.push_back(c);
  }

  const std::vector<Point>& p_;
  Cells cells_;                      // of those not cut off yet
  std::vector<int> before_, after_;  // next to each of these
  std::size_t left_ = 0;
  int start_ = 0;
  std::vector<int> triangles_;
};

}  // namespace

std::vector<int> triangulated(const std::vector<std::array<double, 3>>& polygon) {
  if (polygon.size() < 3) return {};
  const std::vector<Point> points = flattened(polygon);
  if (points.empty()) return {};
  return points.size() == 4 ? cut_quad(points) : EarClipper(points).run();
}

}  // namespace isostretch::mesh

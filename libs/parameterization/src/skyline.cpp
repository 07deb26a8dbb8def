#include "skyline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace isostretch::parameterization {
namespace {

// The upper outline of what is placed: steps from left to right, each up to where the next begins.
class Skyline {
 public:
  explicit Skyline(double width) : width_(width), steps_{{0, 0}} {}

  void place(Rectangle& r) {
    std::size_t best = 0;
    double lowest = HUGE_VAL;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const double y = height_over(i, r.width);
      if (y < lowest) lowest = y, best = i;
    }
    r.x = steps_[best].x;
    r.y = lowest;
    lift(best, r.x + r.width, lowest + r.height);
  }

 private:
  struct Step {
    double x, y;
  };

  double end(std::size_t i) const { return i + 1 < steps_.size() ? steps_[i + 1].x : width_; }

  // Where a piece of that width that begins with step i comes to lie; infinite when it would stick out,
  // unless it fits nowhere.
  double height_over(std::size_t i, double piece) const {
    const double to = steps_[i].x + piece;
    if (i > 0 && to > width_) return HUGE_VAL;
    double highest = 0;
    for (; i < steps_.size() && steps_[i].x < to; ++i) highest = std::max(highest, steps_[i].y);
    return highest;
  }

  void lift(std::size_t first, double to, double y) {
    std::size_t last = first;
    while (last + 1 < steps_.size() && steps_[last + 1].x <= to) ++last;
    const Step rest{to, steps_[last].y};
    const bool remains = to < end(last);
    steps_[first].y = y;
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                 steps_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    if (remains) steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(first) + 1, rest);
  }

  double width_;
  std::vector<Step> steps_;
};

// In whole units, of which sums are exact: otherwise rectangles that differ by a rounding leave useless gaps.
// Returns the unit, or 0 when there is nothing to place.
double round_up(std::vector<Rectangle>& rectangles) {
  double largest = 0, area = 0;
  for (const Rectangle& r : rectangles) {
    largest = std::max({largest, r.width, r.height});
    area += r.width * r.height;
  }
  const double unit = std::max(std::sqrt(area), largest) / 16384;
  if (!(unit > 0)) return 0;
  constexpr double rounding = 1e-9;
  for (Rectangle& r : rectangles) {
    r.width = std::ceil(r.width / unit - rounding);
    r.height = std::ceil(r.height / unit - rounding);
  }
  return unit;
}

}  // namespace

double place_on_skyline(std::vector<Rectangle>& rectangles, double strip_width) {
  std::vector<std::size_t> order(rectangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rectangles[a].height > rectangles[b].height; });
  Skyline skyline(strip_width);
  double top = 0;
  for (const std::size_t i : order) {
    skyline.place(rectangles[i]);
    top = std::max(top, rectangles[i].y + rectangles[i].height);
  }
  return top;
}

double place_in_square(std::vector<Rectangle>& rectangles) {
  const double unit = round_up(rectangles);
  if (unit == 0) return 0;
  double area = 0, widest = 0;
  for (const Rectangle& r : rectangles) {
    area += r.width * r.height;
    widest = std::max(widest, r.width);
  }
  double best_side = HUGE_VAL;
  std::vector<Rectangle> best = rectangles, trial = rectangles;
  const int tries = rectangles.size() < 1000 ? 40 : 8;  // each is quadratic in the worst case
  for (int i = 0; i <= tries; ++i) {
    // The side lies between that of a perfect packing and twice that, unless one rectangle is wider.
    const double width =
        std::max(widest, std::sqrt(area) * (1 + static_cast<double>(i) / tries) * (1 + 1e-12));
    const double side = std::max(width, place_on_skyline(trial, width));
    if (side < best_side) best_side = side, best = trial;
  }
  rectangles = best;
  for (Rectangle& r : rectangles)
    for (double* value : {&r.width, &r.height, &r.x, &r.y}) *value *= unit;
  return best_side * unit;
}

}  // namespace isostretch::parameterization

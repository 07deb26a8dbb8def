#include <isostretch/assembly/roots.hpp>
#include <isostretch/core/pack.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::assembly {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double cubic(double c0, double c1, double c2, double c3, double t) {
  return c0 + t * (c1 + t * (c2 + t * c3));
}

// Root in (low, high] of a cubic that is positive at low, not positive at high and monotone between, from
// below: bisection down to neighbouring numbers is safe and, at some 60 evaluations for the few elements that
// get here, cheap.
double bisect(double c0, double c1, double c2, double c3, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (cubic(c0, c1, c2, c3, middle) > 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace

double smallest_positive_root_quadratic(double c0, double c1, double c2) {
  if (!(c0 > 0)) return 0;
  const double discriminant = product_difference(c1, c1, 4 * c2, c0);
  if (c1 < 0) {
    if (discriminant < 0) return infinity;
    return 2 * c0 / (-c1 + std::sqrt(discriminant));
  }
  if (c2 >= 0) return infinity;
  return (c1 + std::sqrt(discriminant)) / (-2 * c2);
}

double smallest_positive_root_cubic(double c0, double c1, double c2, double c3) {
  if (!(c0 > 0)) return 0;
  if (c1 >= 0 && c2 >= 0 && c3 >= 0) return infinity;
  // Critical points: 3 c3 t^2 + 2 c2 t + c1 = 0.
  double turns[2] = {infinity, infinity};
  const double a = 3 * c3, b = c2;
  const double discriminant = product_difference(b, b, a, c1);
  if (discriminant >= 0) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (a != 0) turns[0] = q / a;
    if (q != 0) turns[1] = c1 / q;
    if (turns[0] > turns[1]) std::swap(turns[0], turns[1]);
  }
  double low = 0;
  for (const double turn : turns) {
    if (!(turn > low) || !std::isfinite(turn)) continue;
    if (cubic(c0, c1, c2, c3, turn) <= 0) return bisect(c0, c1, c2, c3, low, turn);
    low = turn;
  }
  // Monotone from here on: a root lies ahead only where the leading term goes down.
  const double leading = c3 != 0 ? c3 : c2 != 0 ? c2 : c1;
  if (leading >= 0) return infinity;
  double high = std::max(2 * low, 1.0);
  while (cubic(c0, c1, c2, c3, high) > 0) {
    low = high;
    high *= 2;
    if (!std::isfinite(high)) return infinity;
  }
  return bisect(c0, c1, c2, c3, low, high);
}

}  // namespace isostretch::assembly

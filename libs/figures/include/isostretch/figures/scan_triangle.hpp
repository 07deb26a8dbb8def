#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::figures {

/// The span of a row within a triangle.
struct Span {
  /// Left end.
  double left = HUGE_VAL, right = -HUGE_VAL;  ///< Right end.

  /// Widens the span to where the line from a to b crosses the row y. The result is the same to the bit from
  /// b to a: a sample on an edge would otherwise fall between the triangles on both sides.
  void cross(const double* a, const double* b, double y) {
    if ((a[1] <= y) == (b[1] <= y)) return;
    if (a[1] > b[1]) std::swap(a, b);
    const double x = a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
    left = std::min(left, x);
    right = std::max(right, x);
  }
};

/// Returns the first sample centre at or beyond a coordinate, kept in [0, count]; NaN gives 0.
inline int first_sample(double coordinate, int count) {
  const double c = std::ceil(coordinate - 0.5);
  return c > 0 ? static_cast<int>(std::min(c, static_cast<double>(count))) : 0;
}

/// Calls visit(row, from, to) for the rows of samples inside a triangle, in [from, to). Corners are x and y
/// in turn, in samples, in either orientation. A sample on an edge of two triangles belongs to one of them.
template <class Visit>
void scan_triangle(const double (&p)[6], int columns, int rows, Visit&& visit) {
  const int last = first_sample(std::max({p[1], p[3], p[5]}), rows);
  for (int row = first_sample(std::min({p[1], p[3], p[5]}), rows); row < last; ++row) {
    Span span;
    span.cross(p, p + 2, row + 0.5);
    span.cross(p + 2, p + 4, row + 0.5);
    span.cross(p + 4, p, row + 0.5);
    const int from = first_sample(span.left, columns), to = first_sample(span.right, columns);
    if (from < to) visit(row, from, to);
  }
}

}  // namespace isostretch::figures

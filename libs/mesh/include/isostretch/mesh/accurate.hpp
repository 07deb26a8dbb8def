#pragma once

#include <cmath>

namespace isostretch::mesh {

/// a*b - c*d to about one rounding of the result, whatever cancels (Kahan; Jeannerod, Louvet & Muller 2013).
inline double product_difference(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

/// An element is degenerate when its height is below this fraction of its longest edge: what rounding of the
/// coordinates makes of a flat one.
inline constexpr double degenerate_height = 1e-15;

}  // namespace isostretch::mesh

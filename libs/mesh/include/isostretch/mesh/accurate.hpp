#pragma once

#include <cmath>

namespace isostretch::mesh {

/// Returns a*b - c*d to about one rounding of the result, whatever cancels (Kahan; Jeannerod, Louvet and
/// Muller 2013).
inline double product_difference(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

/// The share of its longest edge below which the height of an element makes it degenerate: rounding of the
/// coordinates can give a flat element as much.
inline constexpr double degenerate_height = 1e-15;

}  // namespace isostretch::mesh

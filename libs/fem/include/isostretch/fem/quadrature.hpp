#pragma once

#include <isostretch/mesh/shape.hpp>

#include <vector>

namespace isostretch::mesh {

/// Points inside the reference element of a shape and weights, all positive, that add up to its area or
/// volume.
struct QuadratureRule {
  int dim = 0;
  std::vector<double> points;  ///< [point][dim]
  std::vector<double> weights;

  int size() const { return static_cast<int>(weights.size()); }
};

/// The rule of fewest points that integrates polynomials of that degree exactly: total degree for triangles
/// and tets, degree in each coordinate for quads and hexes.
///
///   degree        1   2   3   4   5
///   triangles     1   3   6   6   7   points (Strang & Fix 1973; Radon 1948)
///   tets          1   4   8  14  14   (Witherden & Vincent 2015; Walkington 2000)
///   quads         1   4   4   9   9   (Gauss-Legendre, first axis fastest)
///   hexes         1   8   8  27  27
///
/// Throws Error for other degrees.
QuadratureRule quadrature_rule(Shape shape, int degree);

/// The degree that elements() uses unless told: 1 for linear triangles and tets, 2 for quadratic ones, 3 for
/// quads and hexes. It gives the stiffness its full rank, and integrates it exactly where the rest shape is
/// affine.
int default_degree(Shape shape) noexcept;

}  // namespace isostretch::mesh

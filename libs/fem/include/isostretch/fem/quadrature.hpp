#pragma once

#include <isostretch/mesh/shape.hpp>

#include <vector>

namespace isostretch::mesh {

/// Points inside the reference element of a shape, and positive weights that add up to its area or volume.
struct QuadratureRule {
  int dim = 0;                  ///< Dimension, 2 or 3.
  std::vector<double> points;   ///< Coordinates, [point][dim].
  std::vector<double> weights;  ///< A weight per point.

  /// Returns the number of points.
  int size() const { return static_cast<int>(weights.size()); }
};

/// Returns the rule of fewest points that integrates polynomials of that degree exactly: total degree for
/// triangles and tets, degree in each coordinate for quads and hexes. Throws Error for degrees other than 1
/// to 5.
///
///     degree        1   2   3   4   5
///     triangles     1   3   6   6   7   points (Strang and Fix 1973; Radon 1948)
///     tets          1   4   8  14  14   (Witherden and Vincent 2015; Walkington 2000)
///     quads         1   4   4   9   9   (Gauss-Legendre, first axis fastest)
///     hexes         1   8   8  27  27
QuadratureRule quadrature_rule(Shape shape, int degree);

/// Returns the degree that elements() uses unless told otherwise: 1 for linear triangles and tets, 2 for
/// quadratic ones, 3 for quads and hexes. It gives the stiffness its full rank, and integrates it exactly
/// where the rest shape is affine.
int default_degree(Shape shape) noexcept;

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/mesh/shape.hpp>

namespace isostretch::mesh {

// Shape functions on VTK's reference elements: the simplex of the origin and the unit points, and the unit
// square or cube.

/// Computes the shape functions at a point of VTK's reference element, one value per node; they add up to
/// one.
void shape_values(Shape shape, const double* point, double* values) noexcept;

/// Computes the gradients of the shape functions over the coordinates of VTK's reference element,
/// [node][dim].
void shape_gradients(Shape shape, const double* point, double* gradients) noexcept;

}  // namespace isostretch::mesh

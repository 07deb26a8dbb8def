#pragma once

#include <isostretch/mesh/shape.hpp>

namespace isostretch::mesh {

// Shape functions on VTK's reference elements: the simplex of the origin and the unit points, and the unit
// square or cube.

/// Writes the values at a point of the reference element, one per node; they add up to one.
void shape_values(Shape shape, const double* point, double* values) noexcept;

/// Writes the gradients by the coordinates of the reference element, [node][dim].
void shape_gradients(Shape shape, const double* point, double* gradients) noexcept;

}  // namespace isostretch::mesh

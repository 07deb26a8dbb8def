#pragma once

namespace isostretch::mesh {

// Elements by their shape functions, on VTK's reference elements: the simplex of the origin and the unit
// points, and the unit square or cube. Nodes are in VTK's order, see types.hpp.
enum class Shape { triangle, quadratic_triangle, quad, tet, quadratic_tet, hex };

const char* shape_name(Shape shape) noexcept;
int shape_dim(Shape shape) noexcept;
int shape_node_count(Shape shape) noexcept;

// At a point of the reference element: one value per node, they add up to one.
void shape_values(Shape shape, const double* point, double* values) noexcept;

// [node][dim], by the coordinates of the reference element.
void shape_gradients(Shape shape, const double* point, double* gradients) noexcept;

}  // namespace isostretch::mesh

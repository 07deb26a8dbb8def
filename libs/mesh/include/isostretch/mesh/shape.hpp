#pragma once

namespace isostretch::mesh {

/// The shapes of elements. Their nodes are in VTK's order, which mesh/types.hpp spells out.
enum class Shape { triangle, quadratic_triangle, quad, tet, quadratic_tet, hex };

/// Returns the name of the shape in words, such as "quadratic tet".
const char* shape_name(Shape shape) noexcept;
/// Returns the dimension of the shape: 2 for flat shapes, 3 for solid ones.
int shape_dim(Shape shape) noexcept;
/// Returns the number of nodes of an element.
int shape_node_count(Shape shape) noexcept;

}  // namespace isostretch::mesh

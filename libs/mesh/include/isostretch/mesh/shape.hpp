#pragma once

namespace isostretch::mesh {

/// Kinds of elements. Their nodes are in VTK's order, see types.hpp.
enum class Shape { triangle, quadratic_triangle, quad, tet, quadratic_tet, hex };

/// Returns the name in words: "quadratic tet".
const char* shape_name(Shape shape) noexcept;
/// Returns 2 for flat shapes and 3 for solid ones.
int shape_dim(Shape shape) noexcept;
/// Returns the number of nodes of an element.
int shape_node_count(Shape shape) noexcept;

}  // namespace isostretch::mesh

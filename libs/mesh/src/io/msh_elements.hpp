#pragma once

#include "elements.hpp"

namespace isostretch::mesh {

inline constexpr int msh_triangle = 2;
inline constexpr int msh_tet = 4;

// Of an element type of Gmsh.
Shape msh_shape(std::int64_t type);
// Nodes of an element, 0 for a type that is not known.
int msh_node_count(std::int64_t type);

}  // namespace isostretch::mesh

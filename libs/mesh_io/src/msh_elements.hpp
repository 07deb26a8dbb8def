#pragma once

#include "elements.hpp"

namespace isostretch::mesh {

inline constexpr int msh_triangle = 2;
inline constexpr int msh_tet = 4;

// Of an element type of Gmsh; no nodes for a type that is not known.
CellKind msh_kind(std::int64_t type);

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/mesh/types.hpp>

#include <array>
#include <vector>

namespace isostretch::mesh {

/// Edges by their vertices, the smaller first, each once.
struct Edges {
  std::vector<std::array<int, 2>> inner, boundary;  ///< of several triangles, of one
};

Edges edges_of(const Triangles& triangles);

}  // namespace isostretch::mesh

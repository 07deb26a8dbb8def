#pragma once

#include <isostretch/mesh/types.hpp>

#include <array>
#include <vector>

namespace isostretch::mesh {

/// The edges of triangles by their vertices, the smaller first, each once.
struct Edges {
  /// Edges of several triangles (inner), of one triangle (boundary).
  std::vector<std::array<int, 2>> inner, boundary;
};

/// Returns the edges of triangles.
Edges edges_of(const Triangles& triangles);

}  // namespace isostretch::mesh

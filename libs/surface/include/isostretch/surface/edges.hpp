#pragma once

#include <isostretch/mesh/types.hpp>

#include <array>
#include <vector>

namespace isostretch::mesh {

/// The edges of triangles by their vertices, the smaller first, each once.
struct Edges {
  /// Edges of several triangles.
  std::vector<std::array<int, 2>> inner, boundary;  ///< Edges of one triangle.
};

/// Returns the edges of triangles.
Edges edges_of(const Triangles& triangles);

}  // namespace isostretch::mesh

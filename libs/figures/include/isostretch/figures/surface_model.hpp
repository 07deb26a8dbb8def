#pragma once

#include <isostretch/figures/color_map.hpp>
#include <isostretch/mesh/types.hpp>
#include <isostretch/surface/edges.hpp>

#include <vector>

namespace isostretch::figures {

/// A surface in space, textured or coloured, as the pictures take it.
struct ModelData {
  const mesh::Points3& vertices;               ///< V x 3.
  const mesh::Triangles& triangles;            ///< F x 3, indices into vertices.
  const mesh::Points2& uv;                     ///< T x 2, texture coordinates.
  const mesh::Triangles& uv_triangles;         ///< F x 3, indices into uv.
  double square = 1;                           ///< Side of the checkerboard's squares, in uv.
  const std::vector<int>& flipped;             ///< Triangles that are turned over.
  std::vector<std::array<int, 2>> lines = {};  ///< Lines to draw dark, as pairs of vertices.
  /// A colour per vertex, mixed in between, instead of the checkerboard; uv is not used then.
  std::vector<Color> colors = {};
};

/// Returns the vertices moved and scaled so that those of triangles lie in the unit ball around the origin,
/// whatever their size was; all others are moved into the box around these.
mesh::Points3 in_unit_ball(const mesh::Points3& vertices, const mesh::Triangles& triangles);

/// Returns normals at vertices, of length 1, weighted by the areas of the triangles around; zero where these
/// leave no direction.
mesh::Points3 smooth_normals(const mesh::Points3& vertices, const mesh::Triangles& triangles);

}  // namespace isostretch::figures

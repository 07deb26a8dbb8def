#pragma once

#include <isostretch/figures/color_map.hpp>
#include <isostretch/mesh/types.hpp>
#include <isostretch/surface/edges.hpp>

#include <vector>

namespace isostretch::figures {

/// A surface in space, textured or coloured, as the pictures take it.
struct ModelData {
  const mesh::Points3& vertices;
  const mesh::Triangles& triangles;
  const mesh::Points2& uv;
  const mesh::Triangles& uv_triangles;
  double square = 1;                           ///< side of the checkerboard's squares, in uv
  const std::vector<int>& flipped;             ///< triangles
  std::vector<std::array<int, 2>> lines = {};  ///< to draw dark, as pairs of vertices
  /// One a vertex, mixed in between, instead of the checkerboard; uv is not used then.
  std::vector<Color> colors = {};
};

/// The vertices moved and scaled so that those of triangles lie in the unit ball around the origin, whatever
/// their size was; all others are moved into the box around these.
mesh::Points3 in_unit_ball(const mesh::Points3& vertices, const mesh::Triangles& triangles);

/// Of length 1, weighted by the areas of the triangles around; zero where these leave no direction.
mesh::Points3 smooth_normals(const mesh::Points3& vertices, const mesh::Triangles& triangles);

}  // namespace isostretch::figures

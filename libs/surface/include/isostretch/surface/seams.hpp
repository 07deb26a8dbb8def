#pragma once

#include <isostretch/mesh/types.hpp>

#include <compare>
#include <vector>

namespace isostretch::mesh {

/// An edge by its vertices, the smaller first.
struct Edge {
  /// The smaller vertex.
  int low = 0, high = 0;  ///< The larger vertex.
  /// Compares by the smaller vertex first.
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// Returns the edges inside the surface at which the texture coordinates of the two triangles differ,
/// ascending: other uv points at one end or both, compared by value, so that a file that writes a point twice
/// has no seam there. Throws Error when the mesh has no uv or an index is out of range.
std::vector<Edge> seams_of_uv(const SurfaceMesh& mesh);

/// Returns the edges as polylines: every path runs between vertices where one, or more than two, of the edges
/// meet; a closed path begins and ends with the same vertex.
std::vector<std::vector<int>> seam_paths(std::vector<Edge> edges);

/// Returns the sum of the lengths of the edges.
double seam_length(const Points3& vertices, const std::vector<Edge>& edges);

}  // namespace isostretch::mesh

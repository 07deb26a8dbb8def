#include "shortest_paths.hpp"

#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/boundary.hpp>

#include <vector>

namespace isostretch::mesh {

std::vector<double> distance_to_boundary(const SurfaceMesh& mesh) {
  std::vector<int> boundary;
  for (const auto& loop : boundary_loops(mesh)) boundary.insert(boundary.end(), loop.begin(), loop.end());
  const HalfEdges surface = half_edges(mesh.triangles, static_cast<int>(mesh.vertices.rows()));
  std::vector<double> lengths(static_cast<std::size_t>(surface.count()));
  for (int h = 0; h < surface.count(); ++h)
    lengths[static_cast<std::size_t>(h)] = length(edge_vector(mesh.vertices, surface.from(h), surface.to(h)));
  return shortest_paths(surface, lengths, boundary).distance;
}

}  // namespace isostretch::mesh

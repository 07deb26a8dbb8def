#include "common/rig_figure.hpp"

#include "common/figures/edges.hpp"

namespace isostretch::app {
namespace {

// Edges of the surface along which a handle ends: both ends are its own, and a neighbour's third vertex is
// not.
std::vector<std::array<int, 2>> handle_outlines(const Rig& rig, const Body& body) {
  std::vector<int> owner(static_cast<std::size_t>(body.nodes.rows()), -1);
  for (std::size_t h = 0; h < rig.handles().size(); ++h)
    for (const int node : rig.handles()[h].nodes) owner[static_cast<std::size_t>(node)] = static_cast<int>(h);
  const auto& surface = body.surface;
  const auto owner_of = [&](int vertex) {
    return owner[static_cast<std::size_t>(surface.original_vertex[static_cast<std::size_t>(vertex)])];
  };
  std::vector<std::array<int, 2>> lines;
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int a = surface.mesh.triangles(t, c), b = surface.mesh.triangles(t, (c + 1) % 3),
                opposite = surface.mesh.triangles(t, (c + 2) % 3);
      if (owner_of(a) >= 0 && owner_of(a) == owner_of(b) && owner_of(opposite) != owner_of(a))
        lines.push_back({a, b});
    }
  return lines;
}

}  // namespace

mesh::Points3 surface_points(const Body& body, const mesh::Points3& points) {
  mesh::Points3 result(static_cast<Eigen::Index>(body.surface.original_vertex.size()), 3);
  for (Eigen::Index v = 0; v < result.rows(); ++v)
    result.row(v) = points.row(body.surface.original_vertex[static_cast<std::size_t>(v)]);
  return result;
}

std::vector<std::array<int, 2>> figure_lines(const Rig& rig, const Body& body) {
  std::vector<std::array<int, 2>> lines = handle_outlines(rig, body);
  if (body.dim == 2) {
    const auto outline = figures::edges_of(body.surface.mesh.triangles).boundary;
    lines.insert(lines.end(), outline.begin(), outline.end());
  }
  return lines;
}

}  // namespace isostretch::app

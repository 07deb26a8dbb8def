#include <isostretch/figures/solid_figure.hpp>

#include <isostretch/surface/edges.hpp>

namespace isostretch::figures {
namespace {

using deformation::Handle;
using deformation::HandleSet;
using deformation::SolidModel;

// Edges of the surface along which a handle ends: both ends are its own, and a neighbour's third vertex is
// not.
std::vector<std::array<int, 2>> handle_outlines(const HandleSet& handle_set, const SolidModel& body) {
  std::vector<int> owner(static_cast<std::size_t>(body.nodes.rows()), -1);
  for (std::size_t h = 0; h < handle_set.handles().size(); ++h)
    for (const int node : handle_set.handles()[h].nodes)
      owner[static_cast<std::size_t>(node)] = static_cast<int>(h);
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

mesh::Points3 surface_points(const SolidModel& body, const mesh::Points3& points) {
  mesh::Points3 result(static_cast<Eigen::Index>(body.surface.original_vertex.size()), 3);
  for (Eigen::Index v = 0; v < result.rows(); ++v)
    result.row(v) = points.row(body.surface.original_vertex[static_cast<std::size_t>(v)]);
  return result;
}

std::vector<std::array<int, 2>> outline(const SolidModel& body) {
  if (body.dim == 3) return {};
  return mesh::edges_of(body.surface.mesh.triangles).boundary;
}

std::vector<Marker> rest_markers(const HandleSet& handle_set, const SolidModel& body, double time) {
  constexpr double least_share = 1e-3;
  std::vector<Marker> markers;
  for (const Handle& handle : handle_set.handles()) {
    Eigen::RowVector3d from = Eigen::RowVector3d::Zero(), to = from;
    for (const int node : handle.nodes) {
      from += body.nodes.row(node) / static_cast<double>(handle.nodes.size());
      to += handle_set.target(handle, node, time).transpose() / static_cast<double>(handle.nodes.size());
    }
    if (handle.nodes.size() == 1) markers.push_back({Marker::Kind::dot, from, from});
    if ((to - from).norm() > least_share * body.diagonal())
      markers.push_back({Marker::Kind::arrow, from, to});
  }
  return markers;
}

std::vector<Marker> target_markers(const HandleSet& handle_set, const SolidModel& body, double time,
                                   const Vector& positions) {
  constexpr std::size_t most = 120;
  std::vector<bool> seen(static_cast<std::size_t>(body.nodes.rows()), false);
  for (const int node : body.surface.original_vertex) seen[static_cast<std::size_t>(node)] = true;
  const mesh::Points3 points = body.points(positions);
  std::vector<Marker> markers;
  for (const Handle& handle : handle_set.handles()) {
    if (handle.nodes.size() == 1) {
      const Eigen::RowVector3d at = points.row(handle.nodes[0]);
      markers.push_back({Marker::Kind::dot, at, at});
    }
    if (!handle.soft) continue;
    std::vector<int> visible;
    for (const int node : handle.nodes)
      if (seen[static_cast<std::size_t>(node)]) visible.push_back(node);
    const std::size_t step = (visible.size() + most - 1) / most;
    for (std::size_t i = 0; i < visible.size(); i += step)
      markers.push_back({Marker::Kind::target, points.row(visible[i]),
                         handle_set.target(handle, visible[i], time).transpose()});
  }
  return markers;
}

std::vector<std::array<int, 2>> figure_lines(const HandleSet& handle_set, const SolidModel& body) {
  std::vector<std::array<int, 2>> lines = handle_outlines(handle_set, body);
  const std::vector<std::array<int, 2>> ends = outline(body);
  lines.insert(lines.end(), ends.begin(), ends.end());
  return lines;
}

}  // namespace isostretch::figures

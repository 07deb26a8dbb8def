#include "findings.hpp"
#include "measure.hpp"
#include "topology.hpp"

namespace isostretch::mesh {
namespace {

bool finite(const Points3& vertices, const int* v, int count) {
  for (int i = 0; i < count; ++i)
    if (!vertices.row(v[i]).allFinite()) return false;
  return true;
}

bool has_distinct_vertices(const int* v) {
  return v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
}

void check_areas(const SurfaceMesh& mesh, Findings& findings) {
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const int* v = mesh.triangles.data() + 3 * t;
    if (!has_distinct_vertices(v) || !finite(mesh.vertices, v, 3)) continue;
    if (triangle_shape(mesh.vertices, v).degenerate())
      findings.add_element(Kind::zero_size, "triangle", mesh.triangles, t, "has zero area");
  }
}

std::string edge_text(const Side& side) {
  return "edge " + std::to_string(side.low) + "-" + std::to_string(side.high);
}

void check_edge(const Side* begin, const Side* end, Findings& findings) {
  if (end - begin > 2) {
    std::vector<int> triangles;
    std::string list;
    for (const Side* side = begin; side < end; ++side) {
      triangles.push_back(side->triangle);
      list += (side == begin ? "" : ", ") + std::to_string(side->triangle);
    }
    findings.add(Kind::non_manifold_edge, triangles, {begin->low, begin->high}, [&] {
      return edge_text(*begin) + " belongs to " + std::to_string(end - begin) + " triangles: " + list;
    });
  } else if (end - begin == 2 && begin[0].reversed == begin[1].reversed) {
    findings.add(Kind::inconsistent_orientation, {begin[0].triangle, begin[1].triangle},
                 {begin->low, begin->high}, [&] {
                   return "triangles " + std::to_string(begin[0].triangle) + " and " +
                          std::to_string(begin[1].triangle) + " are oriented against each other at " +
                          edge_text(*begin);
                 });
  }
}

void check_fans(const Triangles& triangles, const std::vector<Side>& sides, int vertex_count,
                Findings& findings) {
  UnionFind fans = corner_fans(triangles, sides);
  std::vector<int> fan_of(static_cast<std::size_t>(vertex_count), -1);
  std::vector<char> told(fan_of.size(), 0);
  for (const Side& side : sides) {  // every corner of a proper triangle begins one side
    const auto vertex = static_cast<std::size_t>(side.from());
    const int fan = fans.find(3 * side.triangle + side.corner);
    if (fan_of[vertex] < 0) fan_of[vertex] = fan;
    if (fan_of[vertex] == fan || told[vertex]) continue;
    told[vertex] = 1;
    findings.add(Kind::non_manifold_vertex, {fan_of[vertex] / 3, side.triangle}, {side.from()}, [&] {
      return "vertex " + std::to_string(vertex) +
             " joins pieces that share no edge there, such as triangles " +
             std::to_string(fan_of[vertex] / 3) + " and " + std::to_string(side.triangle);
    });
  }
}

// Connected components of the boundary edges.
int count_boundary_loops(const std::vector<Side>& sides, int vertex_count) {
  UnionFind sets(vertex_count);
  std::vector<int> on_boundary;
  for_each_edge(sides, [&](const Side* begin, const Side* end) {
    if (end - begin != 1) return;
    sets.unite(begin->low, begin->high);
    on_boundary.push_back(begin->low);
  });
  std::vector<int> roots;
  for (const int vertex : on_boundary) roots.push_back(sets.find(vertex));
  std::sort(roots.begin(), roots.end());
  return static_cast<int>(std::unique(roots.begin(), roots.end()) - roots.begin());
}

void count_topology(const SurfaceMesh& mesh, const std::vector<Side>& sides, Report& report) {
  int edges = 0;
  for_each_edge(sides, [&](const Side*, const Side*) { ++edges; });
  const auto unreferenced = static_cast<int>(report.count(Kind::unreferenced_vertex));
  report.euler_characteristic =
      static_cast<int>(mesh.vertices.rows()) - unreferenced - edges + static_cast<int>(mesh.triangles.rows());
  report.boundary_loops = count_boundary_loops(sides, static_cast<int>(mesh.vertices.rows()));
  for (const Kind kind : {Kind::degenerate, Kind::duplicate_element, Kind::non_manifold_edge,
                          Kind::non_manifold_vertex, Kind::inconsistent_orientation})
    if (report.count(kind) > 0) return;
  report.genus = (2 * report.components - report.euler_characteristic - report.boundary_loops) / 2;
}

}  // namespace

Report check(const SurfaceMesh& mesh, int max_per_kind) {
  Report report;
  Findings findings(report, max_per_kind);
  check_elements("triangle", mesh.vertices, mesh.triangles, report, findings);
  if (report.indices_valid) {
    check_areas(mesh, findings);
    const std::vector<Side> sides = sorted_sides(mesh.triangles);
    for_each_edge(sides, [&](const Side* begin, const Side* end) { check_edge(begin, end, findings); });
    check_fans(mesh.triangles, sides, static_cast<int>(mesh.vertices.rows()), findings);
    count_topology(mesh, sides, report);
  }
  findings.sort();
  return report;
}

}  // namespace isostretch::mesh

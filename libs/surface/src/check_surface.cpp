#include "defects.hpp"
#include "orient.hpp"

#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/topology.hpp>

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

void check_areas(const SurfaceMesh& mesh, DefectCollector& defects) {
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const int* v = mesh.triangles.data() + 3 * t;
    if (!has_distinct_vertices(v) || !finite(mesh.vertices, v, 3)) continue;
    if (triangle_shape(mesh.vertices, v).degenerate())
      defects.add_element(DefectKind::zero_size, "triangle", mesh.triangles, t, "has zero area");
  }
}

std::string edge_text(const Side& side) {
  return "edge " + std::to_string(side.low) + "-" + std::to_string(side.high);
}

void check_edge(const Side* begin, const Side* end, const OrientedPieces& pieces, DefectCollector& defects) {
  const auto one_sided = [&](int triangle) {
    return pieces.one_sided[static_cast<std::size_t>(pieces.piece[static_cast<std::size_t>(triangle)])] != 0;
  };
  if (end - begin > 2) {
    std::vector<int> triangles;
    std::string list;
    for (const Side* side = begin; side < end; ++side) {
      triangles.push_back(side->triangle);
      list += (side == begin ? "" : ", ") + std::to_string(side->triangle);
    }
    defects.add(DefectKind::non_manifold_edge, triangles, {begin->low, begin->high}, [&] {
      return edge_text(*begin) + " belongs to " + std::to_string(end - begin) + " triangles: " + list;
    });
  } else if (end - begin == 2 && begin[0].reversed == begin[1].reversed && !one_sided(begin->triangle)) {
    defects.add(DefectKind::inconsistent_orientation, {begin[0].triangle, begin[1].triangle},
                {begin->low, begin->high}, [&] {
                  return "triangles " + std::to_string(begin[0].triangle) + " and " +
                         std::to_string(begin[1].triangle) + " are oriented against each other at " +
                         edge_text(*begin);
                });
  }
}

void check_fans(const Triangles& triangles, const std::vector<Side>& sides, int vertex_count,
                DefectCollector& defects) {
  UnionFind fans = corner_fans(triangles, sides);
  std::vector<int> fan_of(static_cast<std::size_t>(vertex_count), -1);
  std::vector<char> told(fan_of.size(), 0);
  for (const Side& side : sides) {  // every corner of a proper triangle begins one side
    const auto vertex = static_cast<std::size_t>(side.from());
    const int fan = fans.find(3 * side.triangle + side.corner);
    if (fan_of[vertex] < 0) fan_of[vertex] = fan;
    if (fan_of[vertex] == fan || told[vertex]) continue;
    told[vertex] = 1;
    defects.add(DefectKind::non_manifold_vertex, {fan_of[vertex] / 3, side.triangle}, {side.from()}, [&] {
      return "vertex " + std::to_string(vertex) +
             " joins pieces that share no edge there, such as triangles " +
             std::to_string(fan_of[vertex] / 3) + " and " + std::to_string(side.triangle);
    });
  }
}

void check_orientable(const OrientedPieces& pieces, DefectCollector& defects) {
  for (std::size_t t = 0; t < pieces.one_sided.size(); ++t)
    if (pieces.one_sided[t])
      defects.add(DefectKind::not_orientable, {static_cast<int>(t)}, {}, [&] {
        return "the surface of triangle " + std::to_string(t) +
               " is one-sided (it contains a Moebius strip) and cannot be oriented";
      });
}

}  // namespace

MeshDiagnostics check(const SurfaceMesh& mesh, int max_per_kind) {
  MeshDiagnostics diagnostics;
  DefectCollector defects(diagnostics, max_per_kind);
  check_elements("triangle", mesh.vertices, mesh.triangles, diagnostics, defects);
  if (diagnostics.indices_valid) {
    check_areas(mesh, defects);
    const std::vector<Side> sides = sorted_sides(mesh.triangles);
    const OrientedPieces pieces = oriented_pieces(mesh.triangles, sides);
    check_orientable(pieces, defects);
    for_each_edge(sides,
                  [&](const Side* begin, const Side* end) { check_edge(begin, end, pieces, defects); });
    check_fans(mesh.triangles, sides, static_cast<int>(mesh.vertices.rows()), defects);
    count_topology(mesh, sides, pieces, diagnostics);
  }
  defects.sort();
  return diagnostics;
}

}  // namespace isostretch::mesh

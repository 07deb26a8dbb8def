#pragma once

// Cuts to disks that are looked at in every respect.
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/types.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/repair.hpp>
#include <isostretch/surface/seams.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace isostretch::mesh::test {

// Edges and how many triangles have them.
inline std::map<Edge, int> edge_uses(const Triangles& triangles) {
  std::map<Edge, int> uses;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(triangles(t, c), triangles(t, (c + 1) % 3));
      ++uses[{low, high}];
    }
  return uses;
}

// Edges inside the input that are on the boundary of the cut mesh.
inline std::vector<Edge> opened_edges(const SurfaceMesh& mesh, const Cut& cut) {
  const std::map<Edge, int> before = edge_uses(mesh.triangles);
  std::set<Edge> opened;
  for (const auto& [edge, uses] : edge_uses(cut.mesh.triangles)) {
    const auto [low, high] = std::minmax({cut.original_vertex[edge.low], cut.original_vertex[edge.high]});
    if (uses == 1 && before.at({low, high}) == 2) opened.insert({low, high});
  }
  return {opened.begin(), opened.end()};
}

inline void same_triangles(const SurfaceMesh& mesh, const Cut& cut) {
  REQUIRE(cut.mesh.triangles.rows() == mesh.triangles.rows());
  REQUIRE(cut.original_vertex.size() == static_cast<std::size_t>(cut.mesh.vertices.rows()));
  bool same = true;
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
    same = same && cut.original_vertex[cut.mesh.triangles.data()[i]] == mesh.triangles.data()[i];
  CHECK(same);
  for (Eigen::Index v = 0; v < cut.mesh.vertices.rows(); ++v)
    same = same && cut.mesh.vertices.row(v) == mesh.vertices.row(cut.original_vertex[v]) &&
           (v >= mesh.vertices.rows() || cut.original_vertex[v] == v);
  CHECK(same);
}

// Everything that cut.hpp promises.
inline void is_cut_of(const SurfaceMesh& mesh, const Cut& cut) {
  same_triangles(mesh, cut);
  const MeshDiagnostics report = check(cut.mesh, 1);
  for (const Defect& defect : report.defects) {
    CAPTURE(defect.text);
    CHECK((defect.kind == DefectKind::duplicate_vertex || defect.kind == DefectKind::several_components ||
           defect.kind == DefectKind::zero_size));
  }
  CHECK(cut.chart == component_of_triangles(cut.mesh.triangles, static_cast<int>(cut.mesh.vertices.rows())));
  REQUIRE(cut.charts.size() == report.component_facts.size());
  for (std::size_t i = 0; i < cut.charts.size(); ++i) {
    CAPTURE(i);
    CHECK(report.component_facts[i].genus == 0);
    CHECK(report.component_facts[i].boundary_loops == cut.charts[i].loops);
    CHECK(report.component_facts[i].triangles == cut.charts[i].triangles);
    CHECK(cut.charts[i].area == doctest::Approx(report.component_facts[i].area));
    CHECK(cut.charts[i].loops >= 1);
  }
  CHECK(cut.seams == opened_edges(mesh, cut));
  std::size_t on_paths = 0;
  for (const std::vector<int>& path : cut.paths()) on_paths += path.size() - 1;
  CHECK(on_paths == cut.seams.size());
}

inline Cut cut_well(const SurfaceMesh& mesh, const CutOptions& options = {}) {
  const Cut cut = cut_to_disks(mesh, options);
  is_cut_of(mesh, cut);
  return cut;
}

// 24 x 24 squares with square holes of 6, 4 and 2 squares a side.
inline SurfaceMesh plate_with_holes() {
  SurfaceMesh mesh = grid(24, 24);
  std::vector<int> kept;
  const auto in = [](int i, int j, int at_i, int at_j, int size) {
    return i >= at_i && i < at_i + size && j >= at_j && j < at_j + size;
  };
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const int i = t / 2 % 24, j = t / 48;
    if (!in(i, j, 3, 4, 6) && !in(i, j, 14, 13, 4) && !in(i, j, 6, 17, 2)) kept.push_back(t);
  }
  SurfaceMesh result = mesh;
  result.triangles.resize(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
    result.triangles.row(static_cast<Eigen::Index>(i)) = mesh.triangles.row(kept[i]);
  repair(result);
  return result;
}

}  // namespace isostretch::mesh::test

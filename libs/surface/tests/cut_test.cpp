// Cutting to disks: what is cut of surfaces of every kind, and what is refused.
#include "cuts.hpp"
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/repair.hpp>
#include <isostretch/surface/seams.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

int pieces_of(const std::vector<Edge>& edges) {
  std::map<int, int> parent;
  const auto find = [&](int v) {
    while (parent.emplace(v, v).first->second != v) v = parent[v];
    return v;
  };
  for (const Edge& edge : edges) parent[find(edge.low)] = find(edge.high);
  return static_cast<int>(std::count_if(parent.begin(), parent.end(),
                                        [](const auto& entry) { return entry.first == entry.second; }));
}

Cut cut_to_one_disk(const SurfaceMesh& mesh, int genus, const CutOptions& options = {}) {
  const Cut cut = cut_well(mesh, options);
  REQUIRE(cut.charts.size() == 1);
  CHECK(cut.charts[0].genus == genus);
  CHECK(cut.charts[0].loops == 1);
  require_disk(cut.mesh);
  return cut;
}

}  // namespace

TEST_CASE("cut: closed surfaces of genus 0, the coarsest included") {
  for (const SurfaceMesh& mesh : {tetrahedron(), octahedron(), slab(0, 1), icosphere(0), icosphere(3),
                                  capped_tube(9, 5), capped_tube(3, 1)}) {
    const Cut cut = cut_to_one_disk(mesh, 0);
    CHECK(pieces_of(cut.seams) == 1);
    CHECK(cut.seams.size() >= 2);
    CHECK(cut.mesh.vertices.rows() - mesh.vertices.rows() == static_cast<int>(cut.seams.size()) - 1);
    CHECK(cut.charts[0].loops_before == 0);
  }
}

TEST_CASE("cut: topology does not mind where vertices are") {
  for (SurfaceMesh mesh : {icosphere(2), torus(7, 5), tube(6, 3)}) {
    mesh.vertices.setZero();
    const Cut cut = cut_well(mesh);
    CHECK(cut.charts[0].loops == 1);
    mesh.vertices.row(3).setOnes();
    cut_well(mesh);
  }
}

TEST_CASE("cut: more ends make the tree longer and never another surface") {
  const SurfaceMesh mesh = slab(0, 4);
  double before = 0;
  for (int ends = 2; ends < 9; ++ends) {
    const Cut cut = cut_to_one_disk(mesh, 0, {.max_terminals = ends, .terminal_distance = 0.1});
    CHECK(pieces_of(cut.seams) == 1);
    CHECK(cut.charts[0].seam_length > before);
    CHECK(cut.charts[0].seam_length == doctest::Approx(seam_length(mesh.vertices, cut.seams)));
    before = 0.8 * cut.charts[0].seam_length;
  }
  const std::size_t two = cut_to_one_disk(mesh, 0, {.max_terminals = 2}).seams.size();
  CHECK(cut_to_one_disk(mesh, 0, {.max_terminals = 8, .terminal_distance = 100, .tip_scale = 100})
            .seams.size() == two);
}

TEST_CASE("cut: disks stay as they are") {
  for (const SurfaceMesh& mesh :
       {surface({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}), square(), grid(7, 4), disc(5)}) {
    const Cut cut = cut_to_one_disk(mesh, 0);
    CHECK(cut.seams.empty());
    CHECK(cut.mesh.triangles == mesh.triangles);
  }
}

TEST_CASE("cut: handles") {
  CHECK(cut_to_one_disk(torus(4, 3), 1).seams.size() > 5);
  const Cut cut = cut_to_one_disk(torus(24, 12), 1);
  CHECK(pieces_of(cut.seams) == 1);
  // Around the hole inside (2 pi (2 - 1)) and around the tube (2 pi).
  CHECK(cut.charts[0].seam_length < 1.1 * 4 * 3.1416);
  for (int handles = 1; handles < 5; ++handles) {
    const CutOptions handles_alone{.tip_scale = 100};
    const Cut opened = cut_to_one_disk(slab(handles, 1), handles, handles_alone);
    CHECK(pieces_of(opened.seams) == 1);
    CHECK(cut_to_one_disk(slab(handles, 3), handles, handles_alone).charts[0].seam_length <
          1.05 * opened.charts[0].seam_length);
  }
}

TEST_CASE("cut: boundary loops are cut to or kept as holes") {
  Cut cut = cut_to_one_disk(tube(12, 8), 0);
  CHECK(cut.seams.size() == 8);
  CHECK(cut.charts[0].loops_before == 2);
  CHECK(cut_well(tube(12, 8), {.holes = Holes::keep_all}).seams.empty());

  const SurfaceMesh plate = plate_with_holes();  // loops of 96, 24, 16 and 8 edges
  CHECK(cut_to_one_disk(plate, 0, {.holes = Holes::cut_all}).charts[0].loops_before == 4);
  CHECK(cut_well(plate, {.holes = Holes::keep_all}).charts[0].loops == 4);
  CHECK(cut_well(plate, {.hole_fraction = 0.2}).charts[0].loops == 3);
  CHECK(cut_well(plate, {.hole_fraction = 0.1}).charts[0].loops == 2);
  CHECK(cut_well(plate, {.hole_fraction = 0}).charts[0].loops == 1);
  CHECK(cut_well(plate, {.hole_fraction = 2}).charts[0].loops == 4);
}

TEST_CASE("cut: handles and holes together") {
  const SurfaceMesh mesh = without(slab(2, 3), {8, 100, 201});
  CHECK(cut_to_one_disk(mesh, 2, {.holes = Holes::cut_all}).charts[0].loops_before == 3);
  CHECK(cut_well(mesh).charts[0].loops == 4);
  CHECK(cut_well(mesh, {.holes = Holes::keep_all}).charts[0].loops == 4);
  CHECK(cut_to_one_disk(mesh, 2, {.hole_fraction = 0}).charts[0].genus == 2);
  // Too coarse to lead the cut around the holes: then they are cut.
  for (int hole = 0; hole < 24; ++hole) cut_well(without(torus(4, 3), {hole}));
  CHECK(cut_well(without(torus(3, 3), {4}), {.holes = Holes::keep_all}).charts[0].loops <= 2);
}

TEST_CASE("cut: surfaces with random holes, seams and options") {
  std::mt19937 random(11);
  const SurfaceMesh wholes[] = {slab(2, 2), torus(12, 8), icosphere(2), disc(6), tube(9, 5), torus(4, 4)};
  for (int round = 0; round < 120; ++round) {
    CAPTURE(round);
    SurfaceMesh mesh = wholes[random() % 6];
    const int holes = static_cast<int>(random() % 12);
    for (int i = 0; i < holes; ++i) {
      const auto t = static_cast<Eigen::Index>(random() % static_cast<unsigned>(mesh.triangles.rows()));
      mesh.triangles.row(t) << 0, 0, 0;  // repair takes it out
    }
    repair(mesh, {.split_vertices = true});
    CutOptions options;
    options.holes = static_cast<Holes>(random() % 3);
    options.hole_fraction = 0.1 * static_cast<double>(random() % 8);
    for (const auto& [edge, uses] : edge_uses(mesh.triangles))
      if (random() % 40 == 0 && round % 2 == 0) options.seams.push_back(edge);
    const Cut cut = cut_well(mesh, options);
    for (const Chart& chart : cut.charts) {
      if (options.holes == Holes::cut_all) CHECK(chart.loops == 1);
      CHECK(chart.loops <= std::max(1, chart.loops_before + 1));
    }
  }
}

TEST_CASE("cut: components on their own") {
  const SurfaceMesh mesh = merge({torus(9, 7), disc(4), icosphere(2), tube(8, 4)});
  const Cut cut = cut_well(mesh);
  REQUIRE(cut.charts.size() == 4);
  const int genus[] = {1, 0, 0, 0}, loops_before[] = {0, 1, 0, 2};
  for (int i = 0; i < 4; ++i) {
    CHECK(cut.charts[i].component == i);
    CHECK(cut.charts[i].genus == genus[i]);
    CHECK(cut.charts[i].loops_before == loops_before[i]);
    CHECK(cut.charts[i].loops == 1);
  }
  // The same seams as alone.
  CHECK(std::equal(cut.seams.begin(), cut.seams.begin() + 3, cut_to_disks(torus(9, 7)).seams.begin()));
}

TEST_CASE("cut: seams that are given are cut, and pieces further where they are no disks") {
  // Around the tube: two tubes, each cut lengthwise.
  std::vector<Edge> ring;
  const SurfaceMesh mesh = tube(10, 6);
  for (int i = 0; i < 10; ++i) {
    const auto [low, high] = std::minmax({i * 7 + 2, (i + 1) % 10 * 7 + 2});
    ring.push_back({low, high});
  }
  const Cut cut = cut_well(mesh, {.seams = ring});
  CHECK(cut.charts.size() == 2);
  CHECK(cut.seams.size() == 16);
  for (const Edge& edge : ring) CHECK(std::binary_search(cut.seams.begin(), cut.seams.end(), edge));
  // Across the tube: a disk, nothing else to cut.
  std::vector<Edge> line;
  for (int j = 0; j < 6; ++j) line.push_back({14 + j, 14 + j + 1});
  CHECK(cut_well(mesh, {.seams = line}).seams == line);
  // A slit of two edges in a sphere makes a disk of it; one edge alone opens nothing.
  const SurfaceMesh sphere = icosphere(2);
  const Cut opened = cut_to_one_disk(sphere, 0);
  const std::vector<Edge> slit(opened.seams.begin(), opened.seams.begin() + 1);
  CHECK(cut_well(sphere, {.seams = slit}).seams == opened.seams);
  CHECK(cut_well(sphere, {.seams = opened.seams}).seams == opened.seams);
  CHECK(cut_well(mesh, {.seams = {{0, 7}}}).seams.size() == 6);  // on the boundary
  CHECK_THROWS_WITH_AS(cut_to_disks(mesh, {.seams = {{0, 69}}}), doctest::Contains("seam 0-69 is no edge"),
                       Error);
  CHECK_THROWS_WITH_AS(cut_to_disks(mesh, {.seams = {{-1, 3}}}), doctest::Contains("seam -1-3"), Error);
}

TEST_CASE("cut: what is no oriented manifold is refused by name") {
  const auto refused = [](const SurfaceMesh& mesh, const char* why) {
    CHECK_THROWS_WITH_AS(cut_to_disks(mesh), doctest::Contains(why), Error);
  };
  refused(SurfaceMesh{}, "it has no triangles");
  refused(glued_strip(9, 3, true, false), "cannot cut the mesh open: the surface of triangle 0 is one-sided");
  refused(glued_strip(9, 5, true, true), "one-sided");
  SurfaceMesh mesh = square();
  mesh.triangles.row(1) << 0, 3, 2;
  refused(mesh, "triangles 0 and 1 are oriented against each other at edge 0-2");
  refused(surface({0, 0, 0, 1, 0, 0, 1, 1, 0, 2, 2, 0, 1, 2, 0}, {0, 1, 2, 2, 3, 4}), "vertex 2 joins");
  refused(surface({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0}, {0, 1, 2, 1, 0, 3, 1, 0, 4}),
          "edge 0-1 belongs to 3 triangles");
  mesh = square();
  mesh.vertices(2, 1) = std::nan("");
  refused(mesh, "vertex 2 has a coordinate");
  mesh.triangles(0, 0) = 7;
  refused(mesh, "index out of range");
}

TEST_CASE("cut: unreferenced vertices and uv are kept") {
  SurfaceMesh mesh = icosphere(1);
  mesh.vertices.conservativeResize(mesh.vertices.rows() + 1, 3);
  mesh.vertices.bottomRows(1).setConstant(7);
  mesh.uv = mesh.vertices.leftCols<2>();
  mesh.uv_triangles = mesh.triangles;
  const Cut cut = cut_to_disks(mesh);
  same_triangles(mesh, cut);
  CHECK(cut.mesh.uv == mesh.uv);
  CHECK(cut.mesh.uv_triangles == mesh.uv_triangles);
}

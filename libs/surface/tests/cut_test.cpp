// Cutting to disks, seams and components.
#include "conditional.hpp"
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/repair.hpp>

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

// Edges and how many triangles have them.
std::map<Edge, int> edge_uses(const Triangles& triangles) {
  std::map<Edge, int> uses;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(triangles(t, c), triangles(t, (c + 1) % 3));
      ++uses[{low, high}];
    }
  return uses;
}

// Edges inside the input that are on the boundary of the cut mesh.
std::vector<Edge> opened_edges(const SurfaceMesh& mesh, const Cut& cut) {
  const std::map<Edge, int> before = edge_uses(mesh.triangles);
  std::set<Edge> opened;
  for (const auto& [edge, uses] : edge_uses(cut.mesh.triangles)) {
    const auto [low, high] = std::minmax({cut.original_vertex[edge.low], cut.original_vertex[edge.high]});
    if (uses == 1 && before.at({low, high}) == 2) opened.insert({low, high});
  }
  return {opened.begin(), opened.end()};
}

void same_triangles(const SurfaceMesh& mesh, const Cut& cut) {
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
void is_cut_of(const SurfaceMesh& mesh, const Cut& cut) {
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

Cut cut_well(const SurfaceMesh& mesh, const CutOptions& options = {}) {
  const Cut cut = cut_to_disks(mesh, options);
  is_cut_of(mesh, cut);
  return cut;
}

Cut cut_to_one_disk(const SurfaceMesh& mesh, int genus, const CutOptions& options = {}) {
  const Cut cut = cut_well(mesh, options);
  REQUIRE(cut.charts.size() == 1);
  CHECK(cut.charts[0].genus == genus);
  CHECK(cut.charts[0].loops == 1);
  require_disk(cut.mesh);
  return cut;
}

SurfaceMesh shuffled(const SurfaceMesh& mesh, unsigned seed, std::vector<int>& original_vertex) {
  std::mt19937 random(seed);
  std::vector<int> order(static_cast<std::size_t>(mesh.triangles.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  original_vertex.resize(static_cast<std::size_t>(mesh.vertices.rows()));
  std::iota(original_vertex.begin(), original_vertex.end(), 0);
  std::shuffle(original_vertex.begin(), original_vertex.end(), random);
  std::vector<int> number(original_vertex.size());
  SurfaceMesh result = mesh;
  for (std::size_t v = 0; v < number.size(); ++v) {
    number[original_vertex[v]] = static_cast<int>(v);
    result.vertices.row(static_cast<Eigen::Index>(v)) = mesh.vertices.row(original_vertex[v]);
  }
  for (std::size_t t = 0; t < order.size(); ++t)
    for (int c = 0, turn = static_cast<int>(random() % 3); c < 3; ++c)
      result.triangles(static_cast<Eigen::Index>(t), c) = number[mesh.triangles(order[t], (c + turn) % 3)];
  return result;
}

std::vector<Edge> renamed(const std::vector<Edge>& edges, const std::vector<int>& names) {
  std::vector<Edge> result;
  for (const Edge& edge : edges) {
    const auto [low, high] = std::minmax({names[edge.low], names[edge.high]});
    result.push_back({low, high});
  }
  std::sort(result.begin(), result.end());
  return result;
}

SurfaceMesh moved(SurfaceMesh mesh, double diameters) {
  const Eigen::RowVector3d size = mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff();
  mesh.vertices.rowwise() += diameters * size.norm() * Eigen::RowVector3d(0.3, -0.8, 0.5);
  return mesh;
}

void cuts_the_same_everywhere(const SurfaceMesh& mesh, const CutOptions& options = {}) {
  CAPTURE(mesh.triangles.rows());
  const std::vector<Edge> seams = cut_to_disks(mesh, options).seams;
  for (const double scale : {1e-6, 0.37, 1e6}) {
    CAPTURE(scale);
    SurfaceMesh scaled = mesh;
    scaled.vertices *= scale;
    CHECK(cut_to_disks(scaled, options).seams == seams);
  }
  for (const double diameters : {1.0, 1e3, 1e6}) {
    CAPTURE(diameters);
    CHECK(cut_to_disks(moved(mesh, diameters), options).seams == seams);
  }
  for (unsigned seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    std::vector<int> original;
    const SurfaceMesh other = shuffled(mesh, seed, original);
    CutOptions renamed_options = options;
    std::vector<int> number(original.size());
    for (std::size_t v = 0; v < original.size(); ++v) number[original[v]] = static_cast<int>(v);
    renamed_options.seams = renamed(options.seams, number);
    CHECK(renamed(cut_to_disks(other, renamed_options).seams, original) == seams);
  }
}

// 24 x 24 squares with square holes of 6, 4 and 2 squares a side.
SurfaceMesh plate_with_holes() {
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

TEST_CASE("cut: where does not depend on numbering, scale and place") {
  cuts_the_same_everywhere(icosphere(3), {.max_terminals = 6, .terminal_distance = 0.1});
  cuts_the_same_everywhere(tetrahedron());
  cuts_the_same_everywhere(octahedron());
  cuts_the_same_everywhere(torus(24, 12));
  cuts_the_same_everywhere(slab(0, 6), {.max_terminals = 8, .terminal_distance = 0.1});
  cuts_the_same_everywhere(slab(2, 4));
  cuts_the_same_everywhere(tube(30, 12));
  cuts_the_same_everywhere(plate_with_holes());
  cuts_the_same_everywhere(plate_with_holes(), {.holes = Holes::cut_all});
  cuts_the_same_everywhere(without(slab(1, 4), {8, 100, 200}), {.hole_fraction = 0.05});
}

TEST_CASE("extend cut: from a vertex to the boundary, still a disk, values carried over") {
  const SurfaceMesh mesh = icosphere(3);
  Cut cut = cut_to_disks(mesh);
  std::mt19937 random(5);
  for (int round = 0; round < 10; ++round) {
    const Cut before = cut;
    const int vertex = static_cast<int>(random() % static_cast<unsigned>(mesh.vertices.rows()));
    std::vector<int> previous;
    try {
      previous = extend_cut(cut, vertex);
    } catch (const Error& error) {
      CHECK(std::string(error.what()).find("is on the boundary already") != std::string::npos);
      continue;
    }
    is_cut_of(mesh, cut);
    require_disk(cut.mesh);
    CHECK(cut.seams.size() > before.seams.size());
    CHECK(cut.charts[0].seam_length == doctest::Approx(seam_length(mesh.vertices, cut.seams)));
    REQUIRE(previous.size() == static_cast<std::size_t>(cut.mesh.vertices.rows()));
    for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
      CHECK(previous[cut.mesh.triangles.data()[i]] == before.mesh.triangles.data()[i]);
    CHECK_THROWS_WITH_AS(extend_cut(cut, vertex), doctest::Contains("on the boundary already"), Error);
  }
}

TEST_CASE("extend cut: in the chart of the vertex only, holes stay holes") {
  const SurfaceMesh mesh = merge({disc(6), plate_with_holes()});
  Cut cut = cut_to_disks(mesh, {.holes = Holes::keep_all});
  const std::vector<Chart> before = cut.charts;
  extend_cut(cut, 127 + 25 * 11 + 12);
  is_cut_of(mesh, cut);
  CHECK(cut.charts[0].seam_length == 0);
  CHECK(cut.charts[1].seam_length > 0);
  CHECK(cut.charts[1].loops == before[1].loops);
  CHECK_THROWS_WITH_AS(extend_cut(cut, -1), doctest::Contains("vertex -1: it does not exist"), Error);
  CHECK_THROWS_WITH_AS(extend_cut(cut, 100000), doctest::Contains("does not exist"), Error);
}

TEST_CASE("seams of uv: where the texture coordinates differ, by value") {
  SurfaceMesh mesh = grid(2, 1);
  mesh.uv = mesh.vertices.leftCols<2>();
  mesh.uv_triangles = mesh.triangles;
  CHECK(seams_of_uv(mesh).empty());
  mesh.uv.conservativeResize(8, 2);  // points 6 and 7: copies of 1 and 4, used by the right half
  mesh.uv.row(6) = mesh.uv.row(1);
  mesh.uv.row(7) = mesh.uv.row(4);
  for (int t = 2; t < 4; ++t)
    for (int c = 0; c < 3; ++c) {
      int& point = mesh.uv_triangles(t, c);
      point = point == 1 ? 6 : point == 4 ? 7 : point;
    }
  CHECK(seams_of_uv(mesh).empty());
  mesh.uv(7, 0) += 0.1;
  CHECK(seams_of_uv(mesh) == std::vector<Edge>{{1, 4}});
  CHECK_THROWS_WITH_AS(seams_of_uv(grid(1, 1)), doctest::Contains("no texture coordinates"), Error);
}

TEST_CASE("seam paths: between ends and branches, and around") {
  using Paths = std::vector<std::vector<int>>;
  CHECK(seam_paths({}).empty());
  CHECK(seam_paths({{3, 7}, {2, 3}, {5, 7}}) == Paths{{2, 3, 7, 5}});
  CHECK(seam_paths({{0, 1}, {1, 2}, {0, 2}}) == Paths{{0, 1, 2, 0}});
  CHECK(seam_paths({{0, 1}, {1, 2}, {1, 3}}) == Paths{{0, 1}, {1, 2}, {1, 3}});
  CHECK(seam_paths({{0, 1}, {1, 2}, {2, 3}, {1, 3}}) == Paths{{0, 1}, {1, 2, 3, 1}});
}

TEST_CASE("components: split and merge") {
  SurfaceMesh mesh = merge({torus(5, 4), square(), tetrahedron()});
  mesh.uv = mesh.vertices.leftCols<2>();
  mesh.uv_triangles = mesh.triangles;
  const std::vector<Part> parts = split(mesh);
  REQUIRE(parts.size() == 3);
  CHECK(parts[1].mesh.triangles == square().triangles);
  CHECK(parts[1].mesh.vertices == square().vertices);
  CHECK(parts[1].original_vertex == std::vector<int>{20, 21, 22, 23});
  CHECK(parts[1].original_triangle == std::vector<int>{40, 41});
  const SurfaceMesh again = merge({parts[0].mesh, parts[1].mesh, parts[2].mesh});
  CHECK(again.vertices == mesh.vertices);
  CHECK(again.triangles == mesh.triangles);
  CHECK(again.uv == mesh.uv);
  CHECK(again.uv_triangles == mesh.uv_triangles);
  CHECK(merge({}).triangles.rows() == 0);
  CHECK_THROWS_WITH_AS(merge({mesh, square()}), doctest::Contains("meshes 0 and 1"), Error);
  CHECK_THROWS_WITH_AS(split(square(), {0, -1}), doctest::Contains("triangle 1 has a negative label"), Error);
  CHECK_THROWS_WITH_AS(split(square(), {0}), doctest::Contains("2 triangles, but 1 labels"), Error);
  CHECK(split(square(), {0, 1}).back().original_vertex == std::vector<int>{0, 2, 3});
}

TEST_CASE("cut: real surfaces" * outside_data({"meshes/surfaces"})) {
  struct Surface {
    std::string name;
    int genus;
    double longest;  // seam against the square root of the area
  };
  for (const Surface& surface : {Surface{"spot.obj", 0, 2.8}, Surface{"cow.obj", 0, 3.9},
                                 Surface{"fertility.off", 4, 3.5}, Surface{"decimated-max.obj", 0, 1.5}}) {
    CAPTURE(surface.name);
    SurfaceMesh mesh = read_surface(outside_path("meshes/surfaces/" + surface.name));
    repair(mesh, {.split_vertices = true});
    const Cut cut = cut_well(mesh);
    int genus = 0;
    double length = 0;
    for (const Chart& chart : cut.charts) {
      genus += chart.genus;
      length += chart.seam_length;
    }
    CHECK(genus == surface.genus);
    CHECK(length < surface.longest * std::sqrt(total_area(mesh)));
    cuts_the_same_everywhere(mesh);
  }
}

TEST_CASE("cut: a finger between others that are longer is reached") {
  // A ball with fingers: the short ones are no vertices far from the tree, but are curved.
  SurfaceMesh ball = icosphere(4);
  const Eigen::RowVector3d fingers[] = {{1, 0, 0}, {-1, 0.1, 0}, {0.1, 1, 0}, {0, 0.1, 1}, {0.7, -0.7, 0.1}};
  const auto tip_distance = [&](const Cut& cut, const Eigen::RowVector3d& direction) {
    Eigen::Index tip = 0;
    (ball.vertices * direction.normalized().transpose()).maxCoeff(&tip);
    double nearest = HUGE_VAL;
    for (const Edge& seam : cut.seams)
      nearest = std::min(nearest, (ball.vertices.row(seam.low) - ball.vertices.row(tip)).norm());
    return nearest;
  };
  for (Eigen::Index v = 0; v < ball.vertices.rows(); ++v) {
    double height = 1;
    for (const Eigen::RowVector3d& finger : fingers) {
      const double angle = std::acos(ball.vertices.row(v).dot(finger.normalized()));
      height += 1.2 * std::exp(-40 * angle * angle);
    }
    ball.vertices.row(v) *= height;
  }
  const Cut few = cut_to_disks(ball, {.max_terminals = 3, .tip_scale = 100}),
            all = cut_to_disks(ball, {.max_terminals = 7, .terminal_distance = 100});
  double farthest = 0;
  for (const Eigen::RowVector3d& finger : fingers) {
    CHECK(tip_distance(all, finger) < 0.4);
    farthest = std::max(farthest, tip_distance(few, finger));
  }
  CHECK(farthest > 0.5);
  cuts_the_same_everywhere(ball);
}

TEST_CASE("extend cut: no spurs, and ends are gone on from") {
  const SurfaceMesh mesh = disc(20);
  Cut cut = cut_to_disks(mesh);
  const auto beside = [&](double x, double y) {
    Eigen::Index nearest = 0;
    (cut.mesh.vertices.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  };
  extend_cut(cut, beside(0.93, 0));  // one edge from the boundary
  CHECK(cut.seams.size() == 4);
  CHECK(cut.paths().size() == 1);
  extend_cut(cut, beside(0.6, 0.02));
  CHECK(cut.paths().size() == 1);  // goes on
  CHECK(cut.seams.size() > 5);
}

TEST_CASE("spurs: branches of one to three edges that end inside the surface") {
  // Vertex (x, y) has number x + 11 y.
  const SurfaceMesh mesh = grid(10, 10);
  const auto cut = [&](std::vector<std::vector<int>> paths) {
    CutOptions options;
    for (const std::vector<int>& path : paths)
      for (std::size_t i = 1; i < path.size(); ++i)
        options.seams.push_back({std::min(path[i - 1], path[i]), std::max(path[i - 1], path[i])});
    return cut_to_disks(mesh, options);
  };
  using Paths = std::vector<std::vector<int>>;
  const std::vector<int> trunk{55, 56, 57, 58, 59, 60, 61, 62, 63};  // from the left side
  CHECK(spurs(cut({})).empty());
  CHECK(spurs(cut({trunk})).empty());
  CHECK(spurs(cut({{55, 56, 57}})) == Paths{{57, 56, 55}});
  CHECK(spurs(cut({trunk, {58, 69}})) == Paths{{69, 58}});
  CHECK(spurs(cut({trunk, {58, 69, 80, 91}})) == Paths{{91, 80, 69, 58}});
  CHECK(spurs(cut({trunk, {58, 69, 80, 91, 102}})).empty());
  CHECK(spurs(cut({trunk, {57, 46}, {59, 70, 81}})) == Paths{{46, 57}, {81, 70, 59}});
  CHECK(spurs(cut({trunk, {63, 64, 65}})).empty());  // from side to side
}

TEST_CASE("enclose: the cap of a mushroom by the narrowest ring of its stem") {
  // Rings of vertices around the z axis, from the boundary up; the last one is closed by a vertex.
  constexpr int segments = 12;
  const double radius[] = {5, 4, 2, 0.6, 0.5, 0.55, 2, 2.5, 1.5}, height[] = {0, 0, 0, 0.5, 1, 1.5, 2, 3, 4};
  constexpr int rings = 9, narrowest = 4;
  SurfaceMesh mushroom;
  mushroom.vertices.resize(rings * segments + 1, 3);
  mushroom.triangles.resize((rings - 1) * segments * 2 + segments, 3);
  int t = 0;
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < segments; ++s) {
      const double angle = 2 * M_PI * s / segments;
      mushroom.vertices.row(r * segments + s) << radius[r] * std::cos(angle), radius[r] * std::sin(angle),
          height[r];
      const int next = (s + 1) % segments, a = r * segments + s, b = r * segments + next;
      if (r + 1 == rings) {
        mushroom.triangles.row(t++) << a, b, rings * segments;
      } else {
        mushroom.triangles.row(t++) << a, b, b + segments;
        mushroom.triangles.row(t++) << a, b + segments, a + segments;
      }
    }
  mushroom.vertices.row(rings * segments) << 0, 0, 4.5;
  const Cut cut = cut_to_disks(mushroom);
  const Encloser encloser(cut);
  std::vector<int> cap, above;
  for (int i = 0; i < t; ++i) {
    if (i >= 7 * 2 * segments) cap.push_back(i);
    if (i >= narrowest * 2 * segments) above.push_back(i);
  }
  const double ring = segments * 2 * 0.5 * std::sin(M_PI / segments);
  const Enclosure found = encloser.enclose(cap, 100);
  CHECK(found.length == doctest::Approx(ring).epsilon(1e-7));
  CHECK(found.triangles == above);
  double area = 0;
  for (const int i : above) {
    const auto p = [&](int c) -> Eigen::RowVector3d {
      return mushroom.vertices.row(mushroom.triangles(i, c));
    };
    area += (p(1) - p(0)).cross(p(2) - p(0)).norm() / 2;
  }
  CHECK(found.area == doctest::Approx(area));
  const SurfaceMesh closed = icosphere(1);
  const Cut whole{closed, {}, std::vector<int>(static_cast<std::size_t>(closed.triangles.rows()), 0), {}, {}};
  CHECK(Encloser(whole).enclose({0}, 100).triangles.empty());  // no boundary
  CHECK(encloser.enclose(cap, 0.99 * ring).triangles.empty());
  CHECK(encloser.enclose(cap, 1.01 * ring).triangles == above);
  CHECK(encloser.enclose({t - 1}, 100).triangles == above);    // its own sides are longer
  CHECK(encloser.enclose({0, t - 1}, 100).triangles.empty());  // on the boundary
  CHECK(encloser.enclose({}, 100).triangles.empty());
  CHECK_THROWS_WITH_AS(encloser.enclose({t}, 100), doctest::Contains("there is no triangle"), Error);
}

TEST_CASE("distances to the boundary go along edges, and there may be none") {
  const SurfaceMesh mesh = grid(4, 4);
  const std::vector<double> distance = distance_to_boundary(mesh);
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    const double x = mesh.vertices(v, 0), y = mesh.vertices(v, 1);
    CHECK(distance[static_cast<std::size_t>(v)] == doctest::Approx(std::min({x, y, 1 - x, 1 - y})));
  }
  for (const double d : distance_to_boundary(icosphere(1))) CHECK(std::isinf(d));
}

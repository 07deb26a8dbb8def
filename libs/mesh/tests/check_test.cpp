#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/boundary.hpp>
#include <isostretch/mesh/check.hpp>
#include <isostretch/mesh/generators.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

void finds(const SurfaceMesh& mesh, Kind kind, const char* text, long count = 1) {
  const Report report = check(mesh);
  CHECK(report.count(kind) == count);
  const Finding* finding = report.find(kind);
  REQUIRE(finding != nullptr);
  CHECK(finding->text.find(text) != std::string::npos);
  CAPTURE(finding->text);
}

void not_a_disk(const SurfaceMesh& mesh, const char* why) {
  CHECK_THROWS_WITH_AS(require_disk(mesh), doctest::Contains(why), Error);
}

void numbers(const SurfaceMesh& mesh, int components, int loops, int euler, int genus) {
  const Report report = check(mesh);
  CHECK(report.clean());
  CHECK(report.components == components);
  CHECK(report.boundary_loops == loops);
  CHECK(report.euler_characteristic == euler);
  CHECK(report.genus == genus);
}

// Two triangles that touch in vertex 2 only.
SurfaceMesh bow_tie() {
  return surface({0, 0, 0, 1, 0, 0, 1, 1, 0, 2, 2, 0, 1, 2, 0}, {0, 1, 2, 2, 3, 4});
}

}  // namespace

TEST_CASE("check: numbers of clean surfaces") {
  numbers(square(), 1, 1, 1, 0);
  numbers(grid(7, 4), 1, 1, 1, 0);
  numbers(disc(5), 1, 1, 1, 0);
  numbers(procedural_face(9), 1, 1, 1, 0);
  numbers(tetrahedron(), 1, 0, 2, 0);
  for (int level = 0; level < 4; ++level) numbers(icosphere(level), 1, 0, 2, 0);
  numbers(torus(8, 6), 1, 0, 0, 1);
  numbers(without(torus(8, 6), {3}), 1, 1, -1, 1);
  numbers(without(grid(6, 6), {27, 28}), 1, 3, -1, 0);
}

TEST_CASE("check: every finding names what it found") {
  SurfaceMesh mesh = square();
  mesh.triangles(1, 2) = 9;
  finds(mesh, Kind::index_out_of_range,
        "triangle 1 (vertices 0 2 9) has an index out of range: there are 4 vertices");
  CHECK_FALSE(check(mesh).indices_valid);
  mesh.triangles(1, 2) = -1;
  finds(mesh, Kind::index_out_of_range, "vertices 0 2 -1");
  mesh = square();
  mesh.vertices(3, 0) = std::numeric_limits<double>::infinity();
  finds(mesh, Kind::not_finite, "vertex 3 has a coordinate that is not finite");
  mesh = square();
  mesh.triangles.row(1) << 0, 2, 2;
  finds(mesh, Kind::degenerate, "triangle 1 (vertices 0 2 2) repeats a vertex");
  finds(mesh, Kind::unreferenced_vertex, "vertex 3 belongs to no element");
  CHECK(check(mesh).count(Kind::zero_size) == 0);
  mesh = square();
  mesh.vertices.row(3) = 0.3 * mesh.vertices.row(2);
  finds(mesh, Kind::zero_size, "triangle 1 (vertices 0 2 3) has zero area");
  mesh = square();
  mesh.vertices.row(3) = mesh.vertices.row(0);
  finds(mesh, Kind::zero_size, "triangle 1");
  finds(surface({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 1, 2, 0}), Kind::duplicate_element,
        "triangle 1 (vertices 1 2 0) has the vertices of triangle 0");
  finds(surface({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0}, {0, 1, 2, 1, 0, 3, 1, 0, 4}),
        Kind::non_manifold_edge, "edge 0-1 belongs to 3 triangles: 0, 1, 2");
  finds(bow_tie(), Kind::non_manifold_vertex,
        "vertex 2 joins pieces that share no edge there, such as triangles 0 and 1");
  mesh = square();
  mesh.triangles.row(1) << 0, 3, 2;
  finds(mesh, Kind::inconsistent_orientation,
        "triangles 0 and 1 are oriented against each other at edge 0-2");
  CHECK(check(mesh).genus == -1);
  finds(surface({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0}, {0, 1, 2, 3, 4, 5}),
        Kind::several_components, "2 components, with triangles 0, 1");
}

TEST_CASE("check: a vertex whose fans only meet through a handle is not manifold") {
  SurfaceMesh mesh = grid(4, 1);  // bent so that two corners coincide: one component, one pinched vertex
  for (int c = 0; c < 3; ++c)
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
      if (mesh.triangles(t, c) == 4) mesh.triangles(t, c) = 0;
  finds(mesh, Kind::non_manifold_vertex, "vertex 0");
}

TEST_CASE("check: a needle is not a zero area") {
  CHECK(check(surface({0, 0, 0, 1, 0, 0, 0.5, 1e-12, 0}, {0, 1, 2})).clean());
  CHECK(check(surface({0, 0, 0, 1e-150, 0, 0, 0, 1e-150, 0}, {0, 1, 2})).clean());
  // Collinear up to rounding of the coordinates.
  CHECK(check(surface({0.1, 0.7, 0.3, 0.2, 1.4, 0.6, 0.1 * 1.3, 0.7 * 1.3, 0.3 * 1.3}, {0, 1, 2}))
            .count(Kind::zero_size) == 1);
}

TEST_CASE("check: long lists are cut, counts are not") {
  SurfaceMesh mesh = grid(10, 10);
  mesh.vertices.setZero();
  const Report report = check(mesh, 3);
  CHECK(report.count(Kind::zero_size) == 200);
  CHECK(report.findings.size() == 3);
}

TEST_CASE("check: an empty mesh") {
  const Report report = check(SurfaceMesh{});
  CHECK(report.clean());
  CHECK(report.components == 0);
  not_a_disk(SurfaceMesh{}, "it has no triangles");
}

TEST_CASE("require_disk: says why not") {
  require_disk(square());
  require_disk(disc(3));
  not_a_disk(icosphere(1), "it has no boundary (a closed surface of genus 0); cut it open first");
  not_a_disk(torus(5, 5), "closed surface of genus 1");
  not_a_disk(without(torus(8, 6), {3}), "it has genus 1, that is 1 handle(s)");
  not_a_disk(without(grid(6, 6), {27, 28}), "it has 3 boundary loops; fill all holes but one");
  not_a_disk(bow_tie(), "vertex 2 joins pieces");
  SurfaceMesh mesh = square();
  mesh.triangles.row(1) << 0, 3, 2;
  not_a_disk(mesh, "the mesh is not a disk: triangles 0 and 1 are oriented against each other");
  mesh = grid(4, 4);
  mesh.triangles.row(7).setConstant(3);
  mesh.triangles.row(9).setConstant(3);
  not_a_disk(
      mesh,
      "triangle 7 (vertices 3 3 3) repeats a vertex (and 1 more findings of the kind 'degenerate element')");
  mesh = square();
  mesh.vertices.row(3) = 0.3 * mesh.vertices.row(2);
  require_disk(mesh);  // topology only
}

TEST_CASE("check: tetrahedra") {
  const TetMesh bar = tet_bar(3, 2, 2, 3, 1, 1);
  Report report = check(bar);
  CHECK(report.clean());
  CHECK(report.components == 1);
  TetMesh mesh = bar;
  std::swap(mesh.tets(5, 0), mesh.tets(5, 1));
  report = check(mesh);
  REQUIRE(report.find(Kind::inverted) != nullptr);
  CHECK(report.find(Kind::inverted)->text.find("tet 5 (vertices") == 0);
  mesh = bar;
  mesh.vertices.row(mesh.tets(7, 3)) = mesh.vertices.row(mesh.tets(7, 0));
  CHECK(check(mesh).count(Kind::zero_size) > 0);
  mesh = bar;
  mesh.tets.row(3) = mesh.tets.row(2);
  CHECK(check(mesh).find(Kind::duplicate_element)->text.find("has the vertices of tet 2") !=
        std::string::npos);
  mesh = bar;
  mesh.tets(3, 1) = mesh.tets(3, 0);
  CHECK(check(mesh).count(Kind::degenerate) == 1);
  mesh.tets(3, 1) = 4000;
  CHECK(check(mesh).count(Kind::index_out_of_range) == 1);
  mesh = bar;
  mesh.vertices.conservativeResize(bar.vertices.rows() + 1, 3);
  mesh.vertices.bottomRows(1).setZero();
  CHECK(check(mesh).count(Kind::unreferenced_vertex) == 1);
}

TEST_CASE("boundary loops: ordered, oriented with the triangles") {
  CHECK(boundary_loops(square()) == std::vector<std::vector<int>>{{0, 1, 2, 3}});
  CHECK(boundary_loops(icosphere(1)).empty());
  const auto loops = boundary_loops(without(grid(3, 3), {8, 9}));  // the middle cell taken out
  REQUIRE(loops.size() == 2);
  CHECK(loops[0] == std::vector<int>{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4});
  CHECK(loops[1] == std::vector<int>{5, 9, 10, 6});
  CHECK_THROWS_WITH_AS(boundary_loops(bow_tie()), doctest::Contains("branches at vertex 2"), Error);
  SurfaceMesh mesh = square();
  mesh.triangles.row(1) << 0, 3, 2;
  CHECK_THROWS_WITH_AS(boundary_loops(mesh), doctest::Contains("oriented against each other"), Error);
  mesh.triangles(1, 1) = 17;
  CHECK_THROWS_WITH_AS(boundary_loops(mesh), doctest::Contains("triangle 1 (vertices 0 17 2)"), Error);
}

#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/components.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

void finds(const SurfaceMesh& mesh, DefectKind kind, const char* text, long count = 1) {
  const MeshDiagnostics report = check(mesh);
  CHECK(report.count(kind) == count);
  const Defect* defect = report.find(kind);
  REQUIRE(defect != nullptr);
  CHECK(defect->text.find(text) != std::string::npos);
  CAPTURE(defect->text);
}

void not_a_disk(const SurfaceMesh& mesh, const char* why) {
  CHECK_THROWS_WITH_AS(require_disk(mesh), doctest::Contains(why), Error);
}

void numbers(const SurfaceMesh& mesh, int components, int loops, int euler, int genus) {
  const MeshDiagnostics report = check(mesh);
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
  finds(mesh, DefectKind::index_out_of_range,
        "triangle 1 (vertices 0 2 9) has an index out of range: there are 4 vertices");
  CHECK_FALSE(check(mesh).indices_valid);
  mesh.triangles(1, 2) = -1;
  finds(mesh, DefectKind::index_out_of_range, "vertices 0 2 -1");
  mesh = square();
  mesh.vertices(3, 0) = std::numeric_limits<double>::infinity();
  finds(mesh, DefectKind::not_finite, "vertex 3 has a coordinate that is not finite");
  mesh = square();
  mesh.triangles.row(1) << 0, 2, 2;
  finds(mesh, DefectKind::degenerate, "triangle 1 (vertices 0 2 2) repeats a vertex");
  finds(mesh, DefectKind::unreferenced_vertex, "vertex 3 belongs to no element");
  CHECK(check(mesh).count(DefectKind::zero_size) == 0);
  mesh = square();
  mesh.vertices.row(3) = 0.3 * mesh.vertices.row(2);
  finds(mesh, DefectKind::zero_size, "triangle 1 (vertices 0 2 3) has zero area");
  mesh = square();
  mesh.vertices.row(3) = mesh.vertices.row(0);
  finds(mesh, DefectKind::zero_size, "triangle 1");
  finds(surface({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 1, 2, 0}), DefectKind::duplicate_element,
        "triangle 1 (vertices 1 2 0) has the vertices of triangle 0");
  finds(surface({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0}, {0, 1, 2, 1, 0, 3, 1, 0, 4}),
        DefectKind::non_manifold_edge, "edge 0-1 belongs to 3 triangles: 0, 1, 2");
  finds(bow_tie(), DefectKind::non_manifold_vertex,
        "vertex 2 joins pieces that share no edge there, such as triangles 0 and 1");
  mesh = square();
  mesh.triangles.row(1) << 0, 3, 2;
  finds(mesh, DefectKind::inconsistent_orientation,
        "triangles 0 and 1 are oriented against each other at edge 0-2");
  CHECK(check(mesh).genus == -1);
  finds(surface({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0}, {0, 1, 2, 3, 4, 5}),
        DefectKind::several_components, "2 components, with triangles 0, 1");
}

TEST_CASE("check: a vertex whose fans only meet through a handle is not manifold") {
  SurfaceMesh mesh = grid(4, 1);  // bent so that two corners coincide: one component, one pinched vertex
  for (int c = 0; c < 3; ++c)
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
      if (mesh.triangles(t, c) == 4) mesh.triangles(t, c) = 0;
  finds(mesh, DefectKind::non_manifold_vertex, "vertex 0");
}

TEST_CASE("check: a needle is not a zero area") {
  CHECK(check(surface({0, 0, 0, 1, 0, 0, 0.5, 1e-12, 0}, {0, 1, 2})).clean());
  CHECK(check(surface({0, 0, 0, 1e-150, 0, 0, 0, 1e-150, 0}, {0, 1, 2})).clean());
  // Collinear up to rounding of the coordinates.
  CHECK(check(surface({0.1, 0.7, 0.3, 0.2, 1.4, 0.6, 0.1 * 1.3, 0.7 * 1.3, 0.3 * 1.3}, {0, 1, 2}))
            .count(DefectKind::zero_size) == 1);
}

TEST_CASE("check: one-sided surfaces") {
  finds(glued_strip(9, 3, true, false), DefectKind::not_orientable,
        "the surface of triangle 0 is one-sided (it contains a Moebius strip) and cannot be oriented");
  const SurfaceMesh klein = glued_strip(9, 5, true, true);
  finds(merge({square(), klein}), DefectKind::not_orientable, "the surface of triangle 2 is one-sided");
  const MeshDiagnostics report = check(klein);
  CHECK(report.count(DefectKind::inconsistent_orientation) == 0);  // nothing to be turned
  CHECK(report.genus == -1);
  CHECK(report.euler_characteristic == 0);
  CHECK(report.component_facts[0].why_no_genus == "it is not orientable");
  CHECK(check(glued_strip(9, 5, false, true)).clean());
  not_a_disk(glued_strip(9, 3, true, false), "one-sided");
}

TEST_CASE("check: facts of every component") {
  SurfaceMesh mesh = merge({torus(6, 5), square(), tube(7, 2), bow_tie()});
  const MeshDiagnostics report = check(mesh);
  REQUIRE(report.component_facts.size() == 4);
  const int genus[] = {1, 0, 0, -1}, loops[] = {0, 1, 2, 1}, euler[] = {0, 1, 0, 1};
  const int first[] = {0, 60, 62, 90}, vertices[] = {30, 4, 21, 5};
  for (int i = 0; i < 4; ++i) {
    const ComponentFacts& facts = report.component_facts[i];
    CAPTURE(i);
    CHECK(facts.genus == genus[i]);
    CHECK(facts.boundary_loops == loops[i]);
    CHECK(facts.euler_characteristic == euler[i]);
    CHECK(facts.first_triangle == first[i]);
    CHECK(facts.vertices == vertices[i]);
    CHECK(facts.why_no_genus.empty() == (genus[i] >= 0));
  }
  const MeshDiagnostics folded = check(surface({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 2, 1, 0}));
  CHECK(folded.genus == -1);
  CHECK(folded.component_facts[0].why_no_genus == "its two triangles have the same vertices");
  CHECK(report.component_facts[1].area == doctest::Approx(1));
  CHECK(report.component_facts[3].why_no_genus == "vertex 57 joins pieces that share no edge there");
  CHECK(report.genus == -1);
}

TEST_CASE("check: vertices in the same place are told, and no fault") {
  SurfaceMesh mesh = merge({square(), square()});
  mesh.triangles.row(0) << 0, 1, 2;
  const MeshDiagnostics report = check(mesh);
  CHECK(report.count(DefectKind::duplicate_vertex) == 4);
  CHECK(report.find(DefectKind::duplicate_vertex)->text == "vertex 4 is where vertex 0 is");
  CHECK_FALSE(report.clean());  // two components
  mesh = square();
  mesh.vertices.conservativeResize(5, 3);
  mesh.vertices.row(4) = mesh.vertices.row(2);
  mesh.triangles(1, 1) = 4;  // open along its diagonal's end
  CHECK(check(mesh).count(DefectKind::duplicate_vertex) == 1);
  CHECK(check(surface({0, 0, 0, 1, 0, 0, -0.0, 1, 0}, {0, 1, 2})).clean());
}

TEST_CASE("check: a report in words") {
  CHECK(to_text(check(square())) ==
        "1 component\n"
        "  from triangle 0: 2 triangles, area 1, 1 boundary loop, Euler characteristic 1, genus 0\n"
        "nothing wrong found\n");
  const std::string text = to_text(check(bow_tie()));
  CHECK(text.find("no genus: vertex 2 joins pieces") != std::string::npos);
  CHECK(text.find("non-manifold vertex: 1\n  vertex 2 joins") != std::string::npos);
  SurfaceMesh mesh = grid(10, 10);
  mesh.vertices.setZero();
  CHECK(to_text(check(mesh, 3)).find("zero size: 200\n  triangle 0 (vertices 0 1 12) has zero area\n") !=
        std::string::npos);
  CHECK(to_text(check(mesh, 3)).find("  and 197 more\n") != std::string::npos);
  mesh.triangles(3, 1) = -4;
  CHECK(to_text(check(mesh)).find("index out of range: 1\n") == 0);
  CHECK(to_text(check(tet_bar(1, 1, 1))) == "1 component\nnothing wrong found\n");
}

TEST_CASE("check: long lists are cut, counts are not") {
  SurfaceMesh mesh = grid(10, 10);
  mesh.vertices.setZero();
  const MeshDiagnostics report = check(mesh, 3);
  CHECK(report.count(DefectKind::zero_size) == 200);
  CHECK(report.count(DefectKind::duplicate_vertex) == 120);
  CHECK(report.defects.size() == 6);
}

TEST_CASE("check: an empty mesh") {
  const MeshDiagnostics report = check(SurfaceMesh{});
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
  MeshDiagnostics report = check(bar);
  CHECK(report.clean());
  CHECK(report.components == 1);
  TetMesh mesh = bar;
  std::swap(mesh.tets(5, 0), mesh.tets(5, 1));
  report = check(mesh);
  REQUIRE(report.find(DefectKind::inverted) != nullptr);
  CHECK(report.find(DefectKind::inverted)->text.find("tet 5 (vertices") == 0);
  mesh = bar;
  mesh.vertices.row(mesh.tets(7, 3)) = mesh.vertices.row(mesh.tets(7, 0));
  CHECK(check(mesh).count(DefectKind::zero_size) > 0);
  mesh = bar;
  mesh.tets.row(3) = mesh.tets.row(2);
  CHECK(check(mesh).find(DefectKind::duplicate_element)->text.find("has the vertices of tet 2") !=
        std::string::npos);
  mesh = bar;
  mesh.tets(3, 1) = mesh.tets(3, 0);
  CHECK(check(mesh).count(DefectKind::degenerate) == 1);
  mesh.tets(3, 1) = 4000;
  CHECK(check(mesh).count(DefectKind::index_out_of_range) == 1);
  mesh = bar;
  mesh.vertices.conservativeResize(bar.vertices.rows() + 1, 3);
  mesh.vertices.bottomRows(1).setZero();
  CHECK(check(mesh).count(DefectKind::unreferenced_vertex) == 1);
}

TEST_CASE("check: faces of tetrahedra") {
  TetMesh mesh;
  mesh.vertices = rows<Points3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 1, 1, 1});
  mesh.tets = rows<Tets>({0, 1, 2, 3, 0, 2, 1, 4, 1, 2, 3, 5});
  CHECK(check(mesh).clean());
  mesh.tets.row(1) << 0, 1, 2, 4;
  MeshDiagnostics report = check(mesh);
  CHECK(report.count(DefectKind::inverted) == 1);
  REQUIRE(report.count(DefectKind::inconsistent_orientation) == 1);
  CHECK(report.find(DefectKind::inconsistent_orientation)->text ==
        "tets 0 and 1 are oriented against each other at face 0-1-2");
  mesh.tets = rows<Tets>({0, 1, 2, 3, 0, 2, 1, 4, 0, 1, 2, 5});
  report = check(mesh);
  REQUIRE(report.count(DefectKind::non_manifold_face) == 1);
  CHECK(report.find(DefectKind::non_manifold_face)->text == "face 0-1-2 belongs to 3 tets: 0, 1, 2");
  CHECK(report.find(DefectKind::non_manifold_face)->elements == std::vector<int>{0, 1, 2});
  mesh.tets = rows<Tets>({0, 1, 2, 3});
  CHECK(check(mesh).count(DefectKind::unreferenced_vertex) == 2);
}

TEST_CASE("boundary loops: lengths") {
  const SurfaceMesh mesh = without(grid(3, 3, 3, 3), {8, 9});
  const auto loops = boundary_loops(mesh);
  CHECK(loop_length(mesh, loops[0]) == doctest::Approx(12));
  CHECK(loop_length(mesh, loops[1]) == doctest::Approx(4));
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

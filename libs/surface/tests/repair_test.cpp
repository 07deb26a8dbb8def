#include "conditional.hpp"
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/repair.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <initializer_list>
#include <random>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

void turn(SurfaceMesh& mesh, int t) {
  std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
  if (mesh.has_uv()) std::swap(mesh.uv_triangles(t, 1), mesh.uv_triangles(t, 2));
}

// The maps of the report lead from the repaired mesh to the input.
void maps_fit(const SurfaceMesh& input, const SurfaceMesh& mesh, const RepairReport& report) {
  REQUIRE(report.original_vertex.size() == static_cast<std::size_t>(mesh.vertices.rows()));
  REQUIRE(report.original_triangle.size() == static_cast<std::size_t>(mesh.triangles.rows()));
  REQUIRE(report.new_vertex.size() == static_cast<std::size_t>(input.vertices.rows()));
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v)
    CHECK(mesh.vertices.row(v) == input.vertices.row(report.original_vertex[v]));
  for (std::size_t v = 0; v < report.new_vertex.size(); ++v)
    if (report.new_vertex[v] >= 0) CHECK(report.original_vertex[report.new_vertex[v]] == static_cast<int>(v));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    int sum = 0;
    for (int c = 0; c < 3; ++c)
      sum += report.original_vertex[mesh.triangles(t, c)] - input.triangles(report.original_triangle[t], c);
    CHECK(sum == 0);
    if (mesh.has_uv())
      for (int c = 0; c < 3; ++c)  // uv was made a copy of the vertices
        CHECK(mesh.uv_triangles(t, c) == report.original_vertex[mesh.triangles(t, c)]);
  }
}

RepairReport repair_well(SurfaceMesh& mesh, const RepairOptions& options = {}) {
  const SurfaceMesh input = mesh;
  const RepairReport report = repair(mesh, options);
  maps_fit(input, mesh, report);
  return report;
}

double volume(const SurfaceMesh& mesh) {
  double six = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto p = [&](int c) { return Eigen::RowVector3d(mesh.vertices.row(mesh.triangles(t, c))); };
    Eigen::Matrix3d m;
    m << p(0), p(1), p(2);
    six += m.determinant();
  }
  return six / 6;
}

}  // namespace

TEST_CASE("repair: nothing to do, nothing done") {
  for (const SurfaceMesh& whole : {square(), torus(6, 5), tetrahedron(), disc(4)}) {
    SurfaceMesh mesh = whole;
    const RepairReport report = repair_well(mesh);
    CHECK_FALSE(report.changed());
    CHECK(to_text(report).empty());
    CHECK(mesh.triangles == whole.triangles);
    CHECK(mesh.vertices == whole.vertices);
  }
  SurfaceMesh empty;
  CHECK_FALSE(repair(empty).changed());
}

TEST_CASE("repair: degenerate and duplicate triangles, vertices of none; uv is carried along") {
  SurfaceMesh mesh = surface({9, 9, 9, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 8, 8, 8},
                             {1, 1, 2, 1, 2, 3, 3, 1, 2, 1, 3, 4, 3, 2, 1, 4, 4, 4});
  mesh.uv = mesh.vertices.leftCols<2>();
  mesh.uv_triangles = mesh.triangles;
  const RepairReport report = repair_well(mesh);
  CHECK(report.degenerate == std::vector<int>{0, 5});
  CHECK(report.duplicates == std::vector<int>{2, 4});
  CHECK(report.unreferenced == std::vector<int>{0, 5});
  CHECK(report.turned.empty());
  CHECK(report.new_vertex == std::vector<int>{-1, 0, 1, 2, 3, -1});
  CHECK(report.original_triangle == std::vector<int>{1, 3});
  CHECK(mesh.triangles == square().triangles);
  CHECK(check(mesh).clean());
  CHECK(to_text(report) ==
        "2 triangle(s) that repeat a vertex removed: 0, 5\n"
        "2 duplicate triangle(s) removed: 2, 4\n"
        "2 vertex(es) of no triangle removed: 0, 5\n");
}

TEST_CASE("repair: every option can be switched off") {
  SurfaceMesh mesh =
      surface({9, 9, 9, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {1, 1, 2, 1, 2, 3, 3, 2, 1, 1, 4, 3});
  const SurfaceMesh input = mesh;
  const RepairOptions none = {.remove_degenerate = false,
                              .remove_duplicates = false,
                              .orient = false,
                              .split_vertices = false,
                              .remove_unreferenced = false};
  CHECK_FALSE(repair(mesh, none).changed());
  CHECK(mesh.triangles == input.triangles);
  CHECK(mesh.vertices == input.vertices);
}

TEST_CASE("repair: orientation of the larger area stays, whatever the order of triangles") {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    SurfaceMesh mesh = icosphere(2);
    for (int t = 0; t < mesh.triangles.rows(); ++t)
      if (random() % 5 < 2) turn(mesh, t);
    const RepairReport report = repair_well(mesh);
    CHECK(report.changed());
    CHECK(check(mesh).clean());
    CHECK(volume(mesh) > 4);
  }
  SurfaceMesh inward = icosphere(1);  // consistent: it stays
  for (int t = 0; t < inward.triangles.rows(); ++t) turn(inward, t);
  CHECK_FALSE(repair_well(inward).changed());
}

TEST_CASE("repair: ties go outward, or by the direction an open piece faces") {
  for (const int first : {0, 1}) {
    SurfaceMesh mesh = octahedron();  // equal areas both ways
    for (int t = first; t < 8; t += 2) turn(mesh, t);
    repair_well(mesh);
    CHECK(check(mesh).clean());
    CHECK(volume(mesh) > 1);
    SurfaceMesh open = square();
    turn(open, first);
    const RepairReport report = repair_well(open);
    CHECK(report.turned == std::vector<int>{first});
    CHECK(open.triangles == square().triangles);
  }
}

TEST_CASE("repair: pieces are oriented on their own, one-sided ones are left and named") {
  SurfaceMesh mesh = merge({disc(3), glued_strip(9, 2, true, false), torus(6, 5)});
  turn(mesh, 7);
  turn(mesh, 54 + 36 + 11);
  const RepairReport report = repair_well(mesh);
  CHECK(report.turned == std::vector<int>{7, 101});
  CHECK(report.one_sided == std::vector<int>{54});
  CHECK(to_text(report).find("1 piece(s) that cannot be oriented left as they are, with triangle: 54") !=
        std::string::npos);
  CHECK(check(mesh).count(DefectKind::not_orientable) == 1);
  CHECK(check(mesh).count(DefectKind::inconsistent_orientation) == 0);
}

TEST_CASE("repair: vertices that join pieces are split when asked to") {
  SurfaceMesh mesh = surface({0, 0, 0, 1, 0, 0, 1, 1, 0, 2, 2, 0, 1, 2, 0}, {0, 1, 2, 2, 3, 4});
  CHECK_FALSE(repair_well(mesh).changed());
  const RepairReport report = repair_well(mesh, {.split_vertices = true});
  CHECK(report.split_vertices == std::vector<int>{2});
  CHECK(report.original_vertex == std::vector<int>{0, 1, 2, 3, 4, 2});
  CHECK(mesh.triangles(0, 2) == 2);
  CHECK(mesh.triangles(1, 0) == 5);
  CHECK(check(mesh).components == 2);
  CHECK(check(mesh).count(DefectKind::non_manifold_vertex) == 0);
}

TEST_CASE("repair: triangles of zero area are reported, not touched") {
  SurfaceMesh mesh = square();
  mesh.vertices.row(3) = 0.3 * mesh.vertices.row(2);
  const RepairReport report = repair_well(mesh);
  CHECK_FALSE(report.changed());
  CHECK(report.zero_area == std::vector<int>{1});
  mesh.triangles(1, 1) = 77;
  CHECK_THROWS_WITH_AS(repair(mesh), doctest::Contains("triangle 1 (vertices 0 77 3)"), Error);
}

TEST_CASE("repair: a real model with a vertex where two fans meet" *
          outside_data({"meshes/surfaces/cow.obj"})) {
  SurfaceMesh mesh = read_surface(outside_path("meshes/surfaces/cow.obj"));
  CHECK(check(mesh).find(DefectKind::non_manifold_vertex)->vertices == std::vector<int>{253});
  const RepairReport report = repair_well(mesh, {.split_vertices = true});
  CHECK(report.split_vertices == std::vector<int>{253});
  const MeshDiagnostics after = check(mesh);
  CHECK(after.count(DefectKind::non_manifold_vertex) == 0);
  CHECK(after.genus >= 0);
}

TEST_CASE("what is left of copies belongs to the groups of all of them") {
  ElementMesh m;
  m.shape = Shape::tet;
  m.vertices.resize(5, 3);
  m.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1;
  m.elements.resize(3, 4);
  m.elements << 0, 1, 2, 3, 1, 2, 3, 4, 2, 1, 0, 3;
  ElementGroup first, second;
  first.elements = {0, 1};
  second.elements = {2};
  m.groups = {first, second};
  repair(m);
  REQUIRE(m.elements.rows() == 2);
  CHECK(m.groups[0].elements == std::vector<int>{0, 1});
  CHECK(m.groups[1].elements == std::vector<int>{0});
}

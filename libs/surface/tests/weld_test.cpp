#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/weld.hpp>
#include <isostretch/surface/repair.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

ElementMesh element_mesh(Shape shape, const Points3& vertices, const std::vector<int>& nodes) {
  ElementMesh mesh;
  mesh.shape = shape;
  mesh.vertices = vertices;
  mesh.elements = Eigen::Map<const decltype(mesh.elements)>(
      nodes.data(), static_cast<Eigen::Index>(nodes.size()) / shape_node_count(shape),
      shape_node_count(shape));
  return mesh;
}

const Points3 corners = rows<Points3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});

}  // namespace

TEST_CASE(
    "weld: triangles of their own vertices become a surface, texture coordinates stay with their corners") {
  SurfaceMesh mesh = surface({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1e-9, 0, 1, 0}, {0, 1, 2, 3, 4, 5});
  mesh.uv = rows<Points2>({0, 0, 1, 0, 1, 1, 5, 5, 6, 6, 5, 6});
  mesh.uv_triangles = mesh.triangles;
  SurfaceMesh exact = mesh;
  CHECK(weld(exact) == 1);
  CHECK(exact.triangles == rows<Triangles>({0, 1, 2, 0, 3, 4}));
  CHECK(weld(mesh, 1e-6) == 2);
  CHECK(mesh.vertices.rows() == 4);
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
  CHECK(mesh.uv_triangles == rows<Triangles>({0, 1, 2, 3, 4, 5}));
  CHECK(weld(mesh) == 0);
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_THROWS_WITH_AS(weld(mesh, bad), doctest::Contains("tolerance"), Error);
  mesh.triangles(0, 0) = 9;
  CHECK_THROWS_WITH_AS(weld(mesh), doctest::Contains("index out of range"), Error);
}

TEST_CASE("weld: elements of any kind") {
  ElementMesh mesh =
      element_mesh(Shape::tet, rows<Points3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 1}),
                   {0, 1, 2, 3, 4, 5, 2, 3});
  CHECK(weld(mesh) == 1);
  CHECK(mesh.vertices == corners);
  CHECK(mesh.elements(1, 0) == 1);
}

TEST_CASE("repair: elements that are there twice go, inverted ones are turned, with their groups") {
  ElementMesh mesh = element_mesh(Shape::tet, corners, {0, 1, 2, 3, 1, 2, 4, 3, 3, 1, 0, 2, 1, 4, 2, 3});
  mesh.groups = {{7, "a", {0, 2}}, {8, "b", {1, 3}}};
  const ElementRepairReport found = find_faults(mesh);
  CHECK(found.duplicates == std::vector<int>{2, 3});
  CHECK(found.inverted == std::vector<int>{1});
  const ElementRepairReport report = repair(mesh);
  CHECK(report.duplicates == found.duplicates);
  CHECK(mesh.elements.rows() == 2);
  CHECK(find_faults(mesh).clean());
  CHECK(mesh.groups[0].elements == std::vector<int>{0});
  CHECK(mesh.groups[1].elements == std::vector<int>{1});
}

TEST_CASE("repair: elements of every shape are turned as a whole") {
  const Points3 cube =
      rows<Points3>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1});
  const Points3 second = rows<Points3>(
      {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, .5, 0, 0, .5, .5, 0, 0, .5, 0, 0, 0, .5, .5, 0, .5, 0, .5, .5});
  struct Case {
    Shape shape;
    Points3 vertices;
    std::vector<int> nodes, turned;
  };
  for (const Case& c :
       {Case{Shape::tet, corners, {0, 2, 1, 3}, {0, 2, 3, 1}},
        Case{Shape::hex, cube, {4, 5, 6, 7, 0, 1, 2, 3}, {0, 1, 2, 3, 4, 5, 6, 7}},
        Case{Shape::triangle, corners, {0, 2, 1}, {0, 1, 2}},
        Case{Shape::quad, cube, {0, 3, 2, 1}, {0, 1, 2, 3}},
        Case{Shape::quadratic_triangle, second, {0, 2, 1, 6, 5, 4}, {0, 1, 2, 4, 5, 6}},
        Case{Shape::quadratic_tet, second, {0, 1, 3, 2, 4, 8, 7, 6, 5, 9}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}}) {
    CAPTURE(shape_name(c.shape));
    ElementMesh mesh = element_mesh(c.shape, c.vertices, c.nodes);
    CHECK(repair(mesh).inverted == std::vector<int>{0});
    CHECK(std::vector<int>(mesh.elements.data(), mesh.elements.data() + mesh.elements.size()) == c.turned);
    CHECK(find_faults(mesh).clean());
  }
}

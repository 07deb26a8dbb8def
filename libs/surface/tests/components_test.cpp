// Surfaces taken apart and put together.
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/surface/components.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

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

#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>
#include <isostretch/surface/boundary_surface.hpp>
#include <isostretch/surface/check.hpp>

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;

namespace {

// By the divergence theorem: positive when the triangles face outwards.
double enclosed_volume(const SurfaceMesh& mesh) {
  double volume = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.triangles(t, 0)),
                             b = mesh.vertices.row(mesh.triangles(t, 1)),
                             c = mesh.vertices.row(mesh.triangles(t, 2));
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

void check_box(const BoundarySurface& surface, Eigen::Index triangles) {
  CHECK(surface.mesh.triangles.rows() == triangles);
  CHECK(surface.element.size() == static_cast<std::size_t>(triangles));
  CHECK(check(surface.mesh).clean());
  CHECK(check(surface.mesh).genus == 0);
  CHECK(check(surface.mesh).boundary_loops == 0);
  CHECK(enclosed_volume(surface.mesh) == doctest::Approx(6));
  CHECK(total_area(surface.mesh) == doctest::Approx(22));
}

}  // namespace

TEST_CASE("the boundary of a box is a closed surface that faces outwards, whatever the elements") {
  const TetMesh tets = tet_bar(3, 2, 2, 3, 2, 1);
  const HexMesh hexes = hex_bar(3, 2, 2, 3, 2, 1);
  check_box(boundary_surface(tets), 2 * 2 * (3 * 2 + 3 * 2 + 2 * 2));
  check_box(boundary_surface(hexes), 2 * 2 * (3 * 2 + 3 * 2 + 2 * 2));
  check_box(boundary_surface(quadratic(tets)), 4 * 2 * 2 * (3 * 2 + 3 * 2 + 2 * 2));
}

TEST_CASE("the maps of a boundary lead back to the solid") {
  const TetMesh bar = tet_bar(2, 2, 3);
  const BoundarySurface surface = boundary_surface(bar);
  CHECK(surface.original_vertex.size() == 36 - 2);  // two vertices are inside
  for (std::size_t i = 0; i < surface.original_vertex.size(); ++i)
    CHECK(surface.mesh.vertices.row(static_cast<Eigen::Index>(i)) ==
          bar.vertices.row(surface.original_vertex[i]));
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int node = surface.original_vertex[static_cast<std::size_t>(surface.mesh.triangles(t, c))];
      CHECK((bar.tets.row(surface.element[static_cast<std::size_t>(t)]).array() == node).any());
    }
}

TEST_CASE("an index out of range is named with its element, and no elements have no boundary") {
  TetMesh mesh = tet_bar(1, 1, 1);
  mesh.tets(2, 1) = 99;
  try {
    boundary_surface(mesh);
    FAIL("nothing thrown");
  } catch (const Error& error) {
    CHECK(std::string(error.what()).find("tet 2") != std::string::npos);
  }
  CHECK(boundary_surface(TetMesh{}).mesh.triangles.rows() == 0);
}

// Meshes that elements cannot be made of, and what is said of them.
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

TEST_CASE("elements that cannot be are refused, naming element, vertices and quadrature point") {
  QuadMesh quads = quad_grid(2, 1);
  quads.quads.row(1) << 1, 4, 5, 2;  // clockwise
  CHECK_THROWS_WITH_AS(elements(quads),
                       "quad 1 (vertices 1 4 5 2) is inverted (negative Jacobian) at quadrature point 0",
                       Error);
  quads = quad_grid(2, 1);
  quads.vertices.row(5) << 0.6, 0.1;  // a dent, seen at the point next to it
  CHECK_THROWS_WITH_AS(elements(quads), doctest::Contains("quad 1 (vertices 1 2 5 4) is inverted"), Error);
  CHECK_THROWS_WITH_AS(elements(quads), doctest::Contains("at quadrature point 3"), Error);
  quads.vertices.row(5) = quads.vertices.row(4) = quads.vertices.row(1);
  CHECK_THROWS_WITH_AS(elements(quads, 1), doctest::Contains("is degenerate (zero Jacobian)"), Error);
  quads.quads(0, 2) = 6;
  CHECK_THROWS_WITH_AS(elements(quads), doctest::Contains("quad 0 (vertices 0 1 6 3): index out of range"),
                       Error);

  auto triangle = quadratic(rows<Points2>({0, 0, 1, 0, 0, 1}), rows<Triangles>({0, 1, 2}));
  triangle.nodes.row(3) << 0.5, 0.6;  // through the opposite corner, almost
  CHECK_THROWS_WITH_AS(elements(triangle),
                       doctest::Contains("quadratic triangle 0 (vertices 0 1 2 3 4 5) is inverted"), Error);
  triangle.nodes(2, 0) = std::nan("");
  CHECK_THROWS_WITH_AS(elements(triangle), doctest::Contains("vertex 2 has a coordinate that is not finite"),
                       Error);

  HexMesh hexes = hex_bar(1, 1, 2);
  hexes.vertices.col(2) *= -1;
  CHECK_THROWS_WITH_AS(elements(hexes), doctest::Contains("hex 0 (vertices 0 1 3 2 4 5 7 6) is inverted"),
                       Error);
  hexes.vertices *= 1e200;
  CHECK_THROWS_WITH_AS(elements(hexes), doctest::Contains("is too large"), Error);

  QuadraticTetMesh tets = quadratic(tet_bar(1, 1, 1));
  tets.nodes.col(1) *= -1;
  CHECK_THROWS_WITH_AS(elements(tets), doctest::Contains("quadratic tet 0 (vertices 0 1 3 7 "), Error);
}

TEST_CASE("elements of an empty mesh are refused, whatever their shape") {
  const auto refused = [](const char* what, const auto& make) {
    CHECK_THROWS_WITH_AS(make(), doctest::Contains((std::string("there is no ") + what).c_str()), Error);
  };
  refused("triangle", [] { flat_elements(SurfaceMesh()); });
  refused("triangle", [] { elements(Points2(), Triangles()); });
  refused("tet", [] { elements(TetMesh()); });
  refused("quad", [] { elements(QuadMesh()); });
  refused("hex", [] { elements(HexMesh()); });
  refused("quadratic triangle", [] { elements(QuadraticTriangleMesh()); });
  refused("quadratic tet", [] { elements(QuadraticTetMesh()); });
}

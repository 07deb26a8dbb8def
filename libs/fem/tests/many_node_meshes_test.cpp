// Meshes for elements of more nodes: quadratic ones made of linear ones, and structured ones.
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>

#include <doctest/doctest.h>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

TEST_CASE("quadratic meshes: shared nodes in the middle of edges, in the order of elements") {
  const auto two = quadratic(rows<Points2>({0, 0, 2, 0, 2, 2, 0, 2}), rows<Triangles>({0, 1, 2, 0, 2, 3}));
  CHECK(two.triangles == rows<QuadraticTriangles>({0, 1, 2, 4, 5, 6, 0, 2, 3, 6, 7, 8}));
  CHECK(two.nodes == rows<Points2>({0, 0, 2, 0, 2, 2, 0, 2, 1, 0, 2, 1, 1, 1, 1, 2, 0, 1}));

  const TetMesh one{rows<Points3>({0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2}), rows<Tets>({0, 1, 2, 3})};
  const QuadraticTetMesh ten = quadratic(one);
  CHECK(ten.tets == rows<QuadraticTets>({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  CHECK(ten.nodes.bottomRows(6) == rows<Points3>({1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1}));

  // Nodes of a bar of n boxes an axis, cut in six: the points of a grid of 2 n.
  CHECK(quadratic(tet_bar(3, 2, 1)).nodes.rows() == 7 * 5 * 3);
  CHECK(quadratic(tet_bar(3, 2, 1)).tets == quadratic(tet_bar(3, 2, 1)).tets);

  CHECK(quadratic(Points2(0, 2), Triangles(0, 3)).nodes.rows() == 0);
  CHECK_THROWS_WITH_AS(quadratic(rows<Points2>({0, 0, 1, 0, 0, 1}), rows<Triangles>({0, 1, 3})),
                       doctest::Contains("triangle 0 (vertices 0 1 3)"), Error);
}

TEST_CASE("structured quads and hexes") {
  const QuadMesh quads = quad_grid(3, 2, 1.5, 1);
  CHECK(quads.vertices == Points2(grid(3, 2, 1.5, 1).vertices.leftCols<2>()));
  CHECK(quads.quads.rows() == 6);
  CHECK(quads.quads.row(4) == rows<Quads>({5, 6, 10, 9}).row(0));
  CHECK(total_weight(elements(quads)) == doctest::Approx(1.5));

  const HexMesh bar = hex_bar(3, 2, 4, 1.5, 1, 2);
  CHECK(bar.vertices == tet_bar(3, 2, 4, 1.5, 1, 2).vertices);
  CHECK(bar.hexes.rows() == 24);
  CHECK(bar.hexes.row(10) == rows<Hexes>({17, 18, 22, 21, 29, 30, 34, 33}).row(0));
  CHECK(total_weight(elements(bar)) == doctest::Approx(3));

  CHECK_THROWS_WITH_AS(hex_bar(1, 1, 0), "layers is 0, must be at least 1", Error);
  CHECK_THROWS_WITH_AS(hex_bar(0, 1, 1), "nx is 0, must be at least 1", Error);
  CHECK_THROWS_WITH_AS(extrude(quads, 2, -1), doctest::Contains("must be positive"), Error);
  CHECK_THROWS_WITH_AS(extrude(quads, 1 << 30), doctest::Contains("too many elements"), Error);
}

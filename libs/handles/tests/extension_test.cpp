#include "body.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/handles/extension.hpp>
#include <isostretch/handles/selection.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>

#include <doctest/doctest.h>

#include <functional>
#include <string>

using namespace isostretch;
using namespace isostretch::handles;

namespace {

using tests::Body;
using tests::body;

Body tets() {
  const auto m = mesh::tet_bar(6, 3, 3, 6, 3, 3);
  return body(mesh::elements(m), m.vertices);
}
Body hexes() {
  const auto m = mesh::hex_bar(6, 2, 2, 6, 2, 2);
  return body(mesh::elements(m), m.vertices);
}
Body quadratic_tets() {
  const auto m = mesh::quadratic(mesh::tet_bar(4, 2, 2, 4, 2, 2));
  return body(mesh::elements(m), m.nodes);
}
Body triangles() {
  const auto m = mesh::grid(8, 3, 8, 3);
  const mesh::Points2 flat = m.vertices.leftCols<2>();
  return body(mesh::elements(flat, m.triangles), flat);
}

using VectorField = std::function<Point(const Point&)>;

Vector sampled(const Nodes& nodes, const VectorField& field) {
  Vector u(nodes.positions.size());
  for (int n = 0; n < nodes.count(); ++n)
    u.segment(nodes.dim * n, nodes.dim) = field(nodes.at(n)).head(nodes.dim);
  return u;
}

std::vector<int> ends(const Nodes& nodes) {
  std::vector<int> both = select(Slab{0, End::min, 0.01}, nodes, "low");
  for (const int n : select(Slab{0, End::max, 0.01}, nodes, "high")) both.push_back(n);
  return both;
}

std::vector<int> outside(const Nodes& nodes) {
  std::vector<int> all;
  for (int axis = 0; axis < nodes.dim; ++axis)
    for (const End end : {End::min, End::max})
      for (const int n : select(Slab{axis, end, 0.01}, nodes, "side")) all.push_back(n);
  return all;
}

}  // namespace

TEST_CASE("handles that are all translated alike take everything along") {
  for (const Body& b : {tets(), hexes(), quadratic_tets(), triangles()})
    for (const ExtensionKind kind : {ExtensionKind::harmonic, ExtensionKind::biharmonic}) {
      const Vector u = sampled(b.nodes, [](const Point&) { return Point(1, -2, 0.5); });
      CHECK((Extension(b.elements, ends(b.nodes), kind).extend(u) - u).cwiseAbs().maxCoeff() < 1e-9);
      CHECK((Extension(b.elements, {0}, kind).extend(u) - u).cwiseAbs().maxCoeff() < 1e-9);
    }
}

TEST_CASE("a boundary that is mapped affinely makes the harmonic extension affine inside") {
  // Affine maps are harmonic; K M^-1 K asks besides that K u vanish at the boundary, which it does not.
  const VectorField affine = [](const Point& p) {
    return Point(0.3 * p.x() - p.y(), 0.2 * p.z() + 1, p.x() + 0.1 * p.y());
  };
  for (const Body& b : {tets(), hexes(), quadratic_tets(), triangles()}) {
    const Vector u = sampled(b.nodes, affine);
    const Vector extended = Extension(b.elements, outside(b.nodes), ExtensionKind::harmonic).extend(u);
    CHECK((extended - u).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("a bar between two ends: harmonic extension is linear along it") {
  const Body b = hexes();
  const Vector u = sampled(b.nodes, [](const Point& p) { return Point(p.x() / 6, 0, 0); });
  CHECK((Extension(b.elements, ends(b.nodes), ExtensionKind::harmonic).extend(u) - u).cwiseAbs().maxCoeff() <
        1e-12);
}

TEST_CASE("the harmonic extension stays between the least and the most that is given") {
  // Of elements without obtuse angles, as those of these bars and grids.
  for (const Body& b : {tets(), triangles()}) {
    const Vector given = sampled(b.nodes, [](const Point& p) { return Point(p.x() > 1 ? p.y() : -1, 0, 0); });
    const Vector u = Extension(b.elements, ends(b.nodes), ExtensionKind::harmonic).extend(given);
    for (int n = 0; n < b.nodes.count(); ++n) {
      CHECK(u[b.nodes.dim * n] >= -1 - 1e-12);
      CHECK(u[b.nodes.dim * n] <= 3 + 1e-12);
    }
  }
}

TEST_CASE("the biharmonic extension leaves the handles without a kink") {
  const Body b = hexes();
  std::vector<int> given = select(Slab{0, End::min, 1.1, false}, b.nodes, "low");
  for (const int n : select(Slab{0, End::max, 1.1, false}, b.nodes, "high")) given.push_back(n);
  const Vector u = sampled(b.nodes, [](const Point& p) { return Point(p.x() > 3 ? 1 : 0, 0, 0); });
  const auto at = [&](ExtensionKind kind, double x) {
    const int n = select(Nearest{{x, 1, 1}, 1}, b.nodes, "probe")[0];
    return Extension(b.elements, given, kind).extend(u)[3 * n];
  };
  CHECK(at(ExtensionKind::harmonic, 2) == doctest::Approx(0.25));
  CHECK(at(ExtensionKind::biharmonic, 2) < 0.21);
  CHECK(at(ExtensionKind::biharmonic, 3) == doctest::Approx(0.5));
}

TEST_CASE("given displacements come out to the bit, and components without any stay") {
  const mesh::TetMesh one = mesh::tet_bar(2, 1, 1);
  mesh::TetMesh two;
  two.vertices.resize(25, 3);
  two.vertices << one.vertices, Eigen::RowVector3d(9, 9, 9), one.vertices.array() + 3;
  two.tets.resize(24, 4);
  two.tets << one.tets, one.tets.array() + 13;
  const Body b = body(mesh::elements(two), two.vertices);
  for (const ExtensionKind kind : {ExtensionKind::harmonic, ExtensionKind::biharmonic}) {
    const Vector u = sampled(b.nodes, [](const Point& p) { return Point(0.1 * p.x() + 1, 0.7, 1 / 3.0); });
    const Vector extended = Extension(b.elements, {0, 5}, kind).extend(u);
    for (const int n : {0, 5}) CHECK(extended.segment(3 * n, 3) == u.segment(3 * n, 3));
    CHECK(extended.segment(0, 36).cwiseAbs().minCoeff() > 0.1);
    CHECK(extended.tail(39).isZero(0));
  }
  CHECK(Extension(b.elements, {}, ExtensionKind::harmonic).extend(Vector::Ones(75)).isZero(0));
}

TEST_CASE("the biharmonic extension is solved on fine sheets and thin plates") {
  const auto sheet = mesh::grid(120, 120, 1, 1);
  const mesh::Points2 flat = sheet.vertices.leftCols<2>();
  const auto plate = mesh::tet_bar(30, 20, 7, 4, 1, 0.01);
  for (const Body& b :
       {body(mesh::elements(flat, sheet.triangles), flat), body(mesh::elements(plate), plate.vertices)}) {
    const Vector u = sampled(b.nodes, [](const Point&) { return Point(1, -2, 0.5); });
    const Vector extended = Extension(b.elements, ends(b.nodes), ExtensionKind::biharmonic).extend(u);
    CHECK((extended - u).cwiseAbs().maxCoeff() < 1e-3);  // the condition is that of K squared
  }
}

TEST_CASE("misuse is named") {
  const Body b = tets();
  CHECK_THROWS_WITH_AS(Extension(b.elements, {3, 1000}, ExtensionKind::harmonic),
                       doctest::Contains("node 1000"), Error);
  CHECK_THROWS_WITH_AS(Extension(b.elements, {3}, ExtensionKind::harmonic).extend(Vector::Zero(5)),
                       doctest::Contains("5 displacements"), Error);
}

// Generators, rest gradients, orientation.
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <numbers>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

// Largest entry of sum of gradients, relative to the largest gradient of the element.
double worst_sum(const ElementArrays& e) {
  double worst = 0;
  for (int t = 0; t < e.element_count(); ++t)
    for (int d = 0; d < e.dim; ++d) {
      double sum = 0, largest = 0;
      for (int n = 0; n < e.nodes_per_element; ++n) {
        const double g = e.gradients[(t * e.nodes_per_element + n) * e.dim + d];
        sum += g;
        largest = std::max(largest, std::abs(g));
      }
      worst = std::max(worst, std::abs(sum) / largest);
    }
  return worst;
}

// J = sum of x_node gradient^T for vertices in space, 3 x dim.
Eigen::MatrixXd jacobian(const ElementArrays& e, const Points3& x, int t) {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, e.dim);
  for (int n = 0; n < e.nodes_per_element; ++n)
    for (int d = 0; d < e.dim; ++d)
      J.col(d) += x.row(e.nodes[t * e.nodes_per_element + n]).transpose() *
                  e.gradients[(t * e.nodes_per_element + n) * e.dim + d];
  return J;
}

// The map from the flat frame back into space is an isometry: J^T J = 1.
double worst_isometry(const SurfaceMesh& mesh) {
  const ElementArrays e = flat_elements(mesh);
  double worst = 0;
  for (int t = 0; t < e.element_count(); ++t) {
    const Eigen::MatrixXd J = jacobian(e, mesh.vertices, t);
    worst = std::max(worst, (J.transpose() * J - Eigen::MatrixXd::Identity(2, 2)).cwiseAbs().maxCoeff());
  }
  return worst;
}

SurfaceMesh one_triangle(std::initializer_list<double> vertices) {
  return surface(vertices, {0, 1, 2});
}

}  // namespace

TEST_CASE("generators: counts, sizes, orientation") {
  const SurfaceMesh g = grid(4, 3, 2.0, 1.5);
  CHECK(g.vertices.rows() == 20);
  CHECK(g.triangles.rows() == 24);
  CHECK(total_area(g) == doctest::Approx(3.0));
  CHECK(count_flipped(g.vertices.leftCols<2>(), g.triangles) == 0);
  const SurfaceMesh d = disc(20);
  CHECK(d.vertices.rows() == 1 + 3 * 20 * 21);
  CHECK(d.triangles.rows() == 6 * 20 * 20);
  CHECK(count_flipped(d.vertices.leftCols<2>(), d.triangles) == 0);
  CHECK(total_area(d) == doctest::Approx(std::numbers::pi).epsilon(0.001));
  const SurfaceMesh s = icosphere(3);
  CHECK(s.vertices.rows() == 642);
  CHECK(s.triangles.rows() == 1280);
  CHECK((s.vertices.rowwise().norm().array() - 1).abs().maxCoeff() < 1e-15);
  CHECK(total_area(s) == doctest::Approx(4 * std::numbers::pi).epsilon(0.02));
  for (Eigen::Index t = 0; t < s.triangles.rows(); ++t) {  // outward
    const Eigen::RowVector3d a = s.vertices.row(s.triangles(t, 0)), b = s.vertices.row(s.triangles(t, 1)),
                             c = s.vertices.row(s.triangles(t, 2));
    CHECK((b - a).cross(c - a).dot(a) > 0);
  }
  const ElementArrays bar = elements(tet_bar(3, 2, 4, 3, 1, 2));
  CHECK(bar.element_count() == 6 * 24);
  CHECK(total_weight(bar) == doctest::Approx(6));
}

TEST_CASE("generators: the procedural face is a disk without bad triangles, far from flat") {
  const SurfaceMesh face = procedural_face(40);
  CHECK(check(face).clean());
  require_disk(face);
  const auto z = face.vertices.col(2);
  CHECK(z.maxCoeff() - z.minCoeff() > 1.5);
}

TEST_CASE("generators: sizes that make no mesh are refused") {
  CHECK_THROWS_WITH_AS(grid(0, 1), doctest::Contains("nx is 0, must be at least 1"), Error);
  CHECK_THROWS_WITH_AS(grid(1, -2), doctest::Contains("ny is -2"), Error);
  CHECK_THROWS_WITH_AS(grid(1, 1, 0), doctest::Contains("width"), Error);
  CHECK_THROWS_WITH_AS(grid(100000, 100000), doctest::Contains("too many"), Error);
  CHECK_THROWS_WITH_AS(disc(0), doctest::Contains("rings"), Error);
  CHECK_THROWS_WITH_AS(icosphere(-1), doctest::Contains("level is -1, must be at least 0"), Error);
  CHECK_THROWS_WITH_AS(icosphere(40), doctest::Contains("too many"), Error);
  CHECK_THROWS_WITH_AS(tet_bar(1, 0, 1), doctest::Contains("ny is 0"), Error);
  CHECK_THROWS_WITH_AS(tet_bar(1, 1, 1, 1, 1, std::nan("")), doctest::Contains("size_z"), Error);
}

TEST_CASE("flat elements: isometric, gradients sum to zero, weights are areas") {
  for (const SurfaceMesh& mesh : {square(), icosphere(2), procedural_face(15), tetrahedron()}) {
    const ElementArrays e = flat_elements(mesh);
    CHECK(e.dim == 2);
    CHECK(e.nodes_per_element == 3);
    CHECK(e.points_per_element == 1);
    CHECK(e.node_count == mesh.vertices.rows());
    CHECK(e.element_count() == mesh.triangles.rows());
    CHECK(worst_sum(e) < 1e-14);
    CHECK(worst_isometry(mesh) < 1e-13);
    CHECK(total_weight(e) == doctest::Approx(total_area(mesh)));
  }
}

TEST_CASE("flat elements: frames are counter-clockwise") {
  // Flat triangles in the plane, mapped to themselves: the determinant of the planar Jacobian is +1.
  const SurfaceMesh mesh = disc(6);
  const ElementArrays e = flat_elements(mesh);
  for (int t = 0; t < e.element_count(); ++t)
    CHECK(jacobian(e, mesh.vertices, t).topRows(2).determinant() == doctest::Approx(1));
}

TEST_CASE("flat elements: needles and flat caps keep their accuracy, at any scale and place") {
  for (const double scale : {1.0, 1e-100, 1e100})
    for (const double thin : {1e-3, 1e-6, 1e-9, 1e-13}) {
      CAPTURE(scale);
      CAPTURE(thin);
      SurfaceMesh cap = one_triangle({0, 0, 0, 1, 0, 0, 0.5, thin, 0});
      SurfaceMesh needle = one_triangle({0, 0, 0, 1, 0, 0, 0, 0, thin});
      SurfaceMesh slanted = one_triangle({0, 0, 0, 1, 2, 3, 0.5, 1, 1.5 + 8 * thin});
      for (SurfaceMesh* mesh : {&cap, &needle, &slanted}) {
        mesh->vertices *= scale;
        CHECK(worst_sum(flat_elements(*mesh)) < 1e-14);
      }
      // Exact values: base 1, height thin.
      CHECK(flat_elements(cap).weights[0] == doctest::Approx(0.5 * thin * scale * scale).epsilon(1e-14));
      CHECK(flat_elements(cap).gradients[5] == doctest::Approx(1 / (thin * scale)).epsilon(1e-14));
      CHECK(flat_elements(needle).weights[0] == doctest::Approx(0.5 * thin * scale * scale).epsilon(1e-14));
    }
  // Isometry is checked through J, whose columns are combinations with weights of size 1 / thin.
  CHECK(worst_isometry(one_triangle({0, 0, 0, 1, 0, 0, 0.25, 1e-7, 0})) < 1e-8);
}

TEST_CASE("flat elements: degenerate triangles are named") {
  SurfaceMesh mesh = square();
  mesh.vertices.row(3) = 0.3 * mesh.vertices.row(2);
  CHECK_THROWS_WITH_AS(flat_elements(mesh), doctest::Contains("triangle 1 (vertices 0 2 3) has zero area"),
                       Error);
  mesh = square();
  mesh.triangles(1, 1) = 0;
  CHECK_THROWS_WITH_AS(flat_elements(mesh), doctest::Contains("triangle 1 (vertices 0 0 3) has zero area"),
                       Error);
  mesh = square();
  mesh.triangles(1, 1) = 4;
  CHECK_THROWS_WITH_AS(flat_elements(mesh),
                       doctest::Contains("triangle 1 (vertices 0 4 3): index out of range"), Error);
  mesh = square();
  mesh.vertices(1, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(flat_elements(mesh), doctest::Contains("vertex 1 has a coordinate"), Error);
}

TEST_CASE("planar elements: linear functions are reproduced, clockwise triangles refused") {
  const SurfaceMesh mesh = disc(7);
  Points2 points = mesh.vertices.leftCols<2>();
  const ElementArrays e = elements(points, mesh.triangles);
  CHECK(worst_sum(e) < 1e-14);
  for (int t = 0; t < e.element_count(); ++t) {
    double gx = 0, gy = 0;
    for (int n = 0; n < 3; ++n) {
      const int v = e.nodes[3 * t + n];
      const double f = 3 * points(v, 0) - 5 * points(v, 1) + 2;
      gx += f * e.gradients[(3 * t + n) * 2];
      gy += f * e.gradients[(3 * t + n) * 2 + 1];
    }
    CHECK(gx == doctest::Approx(3).epsilon(1e-12));
    CHECK(gy == doctest::Approx(-5).epsilon(1e-12));
  }
  Triangles turned = mesh.triangles;
  turned.row(4) = mesh.triangles.row(4).reverse();
  CHECK_THROWS_WITH_AS(elements(points, turned), doctest::Contains("triangle 4 (vertices"), Error);
  CHECK_THROWS_WITH_AS(elements(points, turned), doctest::Contains("is clockwise"), Error);
  points.setZero();
  CHECK_THROWS_WITH_AS(elements(points, mesh.triangles), doctest::Contains("triangle 0"), Error);
}

TEST_CASE("tet elements: linear functions are reproduced, inverted and flat tets named") {
  TetMesh mesh = tet_bar(3, 2, 2, 2.0, 1.0, 0.7);
  const ElementArrays e = elements(mesh);
  CHECK(e.dim == 3);
  CHECK(e.nodes_per_element == 4);
  CHECK(worst_sum(e) < 1e-14);
  Eigen::MatrixXd A(3, 3);
  A << 1, 2, 3, -1, 0.5, 2, 0, 1, 4;
  const Points3 mapped = mesh.vertices * A.transpose();
  for (int t = 0; t < e.element_count(); ++t) CHECK((jacobian(e, mapped, t) - A).norm() < 1e-12);
  std::swap(mesh.tets(3, 0), mesh.tets(3, 1));
  CHECK_THROWS_WITH_AS(elements(mesh), doctest::Contains("tet 3 (vertices"), Error);
  CHECK_THROWS_WITH_AS(elements(mesh), doctest::Contains("is inverted"), Error);
  mesh = tet_bar(1, 1, 1);
  mesh.vertices.col(2).setZero();
  CHECK_THROWS_WITH_AS(elements(mesh), doctest::Contains("tet 0 (vertices 0 1 3 7) has zero volume"), Error);
}

TEST_CASE("scaling to total weight one scales gradients by the inverse length") {
  for (ElementArrays e : {flat_elements(icosphere(1)), elements(tet_bar(2, 1, 1, 4, 3, 2))}) {
    const ElementArrays before = e;
    const double factor = scale_to_total_weight(e);
    CHECK(total_weight(e) == doctest::Approx(1));
    CHECK(e.weights[0] == doctest::Approx(before.weights[0] * std::pow(factor, e.dim)));
    CHECK(e.gradients[1] == doctest::Approx(before.gradients[1] / factor));
  }
  ElementArrays empty;
  CHECK_THROWS_WITH_AS(scale_to_total_weight(empty), doctest::Contains("cannot scale"), Error);
}

TEST_CASE("orientation: flipped triangles, smallest area and where") {
  const SurfaceMesh mesh = grid(4, 4);
  Points2 uv = mesh.vertices.leftCols<2>();
  OrientationReport report = orientation(uv, mesh.triangles);
  CHECK(report.flipped.empty());
  CHECK(report.total_area == doctest::Approx(1));
  CHECK(report.smallest_area == doctest::Approx(1.0 / 32));
  uv.row(6) << 0.6, 0.25;  // pushed beyond its right neighbour
  report = orientation(uv, mesh.triangles);
  CHECK(report.flipped.size() > 0);
  CHECK(report.smallest_area < 0);
  CHECK(report.smallest_triangle >= 0);
  CHECK(count_flipped(-mesh.vertices.leftCols<2>().rowwise().reverse(), mesh.triangles) == 32);
  uv.setZero();
  CHECK(count_flipped(uv, mesh.triangles) == 32);
  uv(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK(count_flipped(uv, mesh.triangles) == 32);
  CHECK_THROWS_WITH_AS(count_flipped(uv.topRows(5), mesh.triangles), doctest::Contains("index out of range"),
                       Error);
  CHECK(orientation(Points2(), Triangles()).smallest_triangle == -1);
}

TEST_CASE("orientation: the sign is right where plain evaluation rounds to zero") {
  const double e = 0x1p-52;
  const Points2 uv = rows<Points2>({0, 0, 1, 1 - e, 1 + e, 1});
  CHECK(orientation(uv, rows<Triangles>({0, 1, 2})).smallest_area ==
        doctest::Approx(0.5 * e * e).epsilon(1e-12));
}

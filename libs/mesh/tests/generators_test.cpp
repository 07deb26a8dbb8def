// Crossed grids, balls and the quadruped.
#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/boundary_surface.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

using namespace isostretch;
using namespace isostretch::mesh;

namespace {

// 1 of a regular tetrahedron, 0 of a flat one.
double quality(const TetMesh& mesh, Eigen::Index t) {
  Eigen::Matrix<double, 4, 3> p;
  for (int c = 0; c < 4; ++c) p.row(c) = mesh.vertices.row(mesh.tets(t, c));
  double squares = 0;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) squares += (p.row(a) - p.row(b)).squaredNorm() / 6;
  Eigen::Matrix3d edges;
  for (int c = 0; c < 3; ++c) edges.row(c) = p.row(c + 1) - p.row(0);
  return std::numbers::sqrt2 * edges.determinant() / std::pow(squares, 1.5);
}

// One closed surface like a sphere, vertices of the inside left out.
void check_is_one_ball(const TetMesh& mesh) {
  const MeshDiagnostics inside = check(mesh);
  CHECK(inside.clean());
  CHECK(inside.components == 1);
  const MeshDiagnostics outside = check(boundary_surface(mesh).mesh);
  CHECK(outside.clean());
  CHECK(outside.components == 1);
  CHECK(outside.boundary_loops == 0);
  CHECK(outside.euler_characteristic == 2);
}

}  // namespace

TEST_CASE("a crossed grid: corners first, then centres, four triangles around each") {
  const SurfaceMesh mesh = crossed_grid(6, 4, 3, 1);
  CHECK(mesh.vertices.rows() == 7 * 5 + 6 * 4);
  CHECK(mesh.triangles.rows() == 4 * 6 * 4);
  CHECK(mesh.vertices.topRows(35) == grid(6, 4, 3, 1).vertices);
  CHECK((mesh.vertices.row(35) - Eigen::RowVector3d(0.25, 0.125, 0)).norm() < 1e-15);
  CHECK((mesh.vertices.row(58) - Eigen::RowVector3d(2.75, 0.875, 0)).norm() < 1e-15);
  const OrientationReport report = orientation(Points2(mesh.vertices.leftCols<2>()), mesh.triangles);
  CHECK(report.smallest_area == doctest::Approx(3.0 / 96));
  CHECK(report.total_area == doctest::Approx(3));
  const MeshDiagnostics found = check(mesh);
  CHECK(found.clean());
  CHECK(found.boundary_loops == 1);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) CHECK(mesh.triangles(t, 2) >= 35);
}

TEST_CASE("a ball is round, one piece, and without flat tetrahedra but across the cube's edges") {
  for (const int n : {2, 4, 8, 12}) {
    CAPTURE(n);
    const TetMesh mesh = ball(n);
    CHECK(mesh.vertices.rows() == (n + 1) * (n + 1) * (n + 1));
    CHECK(mesh.tets.rows() == 5 * n * n * n);
    check_is_one_ball(mesh);
    const BoundarySurface surface = boundary_surface(mesh);
    CHECK((surface.mesh.vertices.rowwise().norm().array() - 1).abs().maxCoeff() < 1e-14);
    CHECK(mesh.vertices.rowwise().norm().maxCoeff() < 1 + 1e-14);
    double least = 1, least_across = 1;
    int across = 0;
    for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
      bool on_sphere = true;
      for (int c = 0; c < 4; ++c) on_sphere &= mesh.vertices.row(mesh.tets(t, c)).norm() > 1 - 1e-12;
      across += on_sphere;
      double& least_of_kind = on_sphere ? least_across : least;
      least_of_kind = std::min(least_of_kind, quality(mesh, t));
    }
    CHECK(across == 12 * n - 16);
    CHECK(least > 0.3);
    CHECK(least_across > 0.4 / n);
  }
  CHECK(total_weight(elements(ball(12))) == doctest::Approx(4 * std::numbers::pi / 3).epsilon(0.02));
}

TEST_CASE("vertices of a ball are numbered with z fastest") {
  const TetMesh mesh = ball(4);
  const auto is_at = [&](int vertex, const Eigen::RowVector3d& place) {
    return (mesh.vertices.row(vertex) - place).norm() < 1e-14;
  };
  CHECK(is_at(0, Eigen::RowVector3d::Constant(-std::sqrt(1 / 3.0))));
  CHECK(is_at(60, {0, 0, -1}));
  CHECK(is_at(62, {0, 0, 0}));
  CHECK(is_at(64, {0, 0, 1}));
  CHECK(is_at(12, {-1, 0, 0}));
}

TEST_CASE("a quadruped is one piece with a manifold boundary and no bad tetrahedron") {
  for (const int n : {12, 13, 16, 21, 30}) {
    CAPTURE(n);
    const TetMesh mesh = quadruped(n);
    check_is_one_ball(mesh);
    double least = 1;
    for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) least = std::min(least, quality(mesh, t));
    CHECK(least >= 0.15 - 1e-12);
    CHECK(mesh.vertices.col(0).minCoeff() < 0.05);
    CHECK(mesh.vertices.col(0).maxCoeff() == doctest::Approx(1).epsilon(0.03));
  }
}

TEST_CASE("a quadruped stands on four legs") {
  const TetMesh mesh = quadruped(24);
  int feet[2][2] = {};
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    if (mesh.vertices(v, 2) > 0.1) continue;
    const double x = mesh.vertices(v, 0), y = mesh.vertices(v, 1);
    CHECK(std::min(std::hypot(x - 0.2, std::abs(y) - 0.135), std::hypot(x - 0.59, std::abs(y) - 0.135)) <
          0.1);
    ++feet[x > 0.4][y > 0];
  }
  for (const auto& pair : feet)
    for (const int count : pair) CHECK(count > 5);
}

TEST_CASE("sizes of crossed grids, balls and quadrupeds that make no sense") {
  CHECK_THROWS_WITH_AS(crossed_grid(0, 1), doctest::Contains("nx is 0"), Error);
  CHECK_THROWS_WITH_AS(crossed_grid(1, 1, 1, -1), doctest::Contains("height"), Error);
  CHECK_THROWS_WITH_AS(crossed_grid(50000, 50000), doctest::Contains("too many"), Error);
  CHECK_THROWS_WITH_AS(ball(0), doctest::Contains("n is 0"), Error);
  CHECK_THROWS_WITH_AS(ball(5), doctest::Contains("even"), Error);
  CHECK_THROWS_WITH_AS(ball(2000), doctest::Contains("too many"), Error);
  CHECK_THROWS_WITH_AS(quadruped(11), doctest::Contains("at least 12"), Error);
  CHECK_THROWS_WITH_AS(quadruped(5000), doctest::Contains("too many"), Error);
}

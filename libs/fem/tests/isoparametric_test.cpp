// Isoparametric elements: gradients, areas and volumes of curved and straight rest shapes.
#include "box_meshes.hpp"
#include "meshes.hpp"

#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>

using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

Eigen::VectorXd same(const Eigen::VectorXd& x) {
  return x;
}

// Neither affine nor symmetric; the boundary is curved as well.
Eigen::VectorXd bend(const Eigen::VectorXd& x) {
  Eigen::VectorXd y = x;
  for (Eigen::Index d = 0; d < x.size(); ++d)
    y[d] += 0.06 * std::sin(3 * x[(d + 1) % x.size()] + static_cast<double>(d)) * std::cos(2 * x[d]);
  return y;
}

// F at a point (counted over all elements) when the nodes are at the rows of x.
Eigen::MatrixXd deformation(const ElementArrays& e, int point, const Eigen::MatrixXd& x) {
  const int n = e.nodes_per_element;
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(e.dim, e.dim);
  for (int a = 0; a < n; ++a) {
    const int node = e.nodes[static_cast<std::size_t>(point / e.points_per_element * n + a)];
    F += x.row(node).transpose() *
         Eigen::Map<const Eigen::RowVectorXd>(e.gradients.data() + (point * n + a) * e.dim, e.dim);
  }
  return F;
}

}  // namespace

TEST_CASE("curved rest shapes: gradients add up to zero and affine maps come out exactly") {
  const Eigen::Matrix3d A3{{0.7, -1.2, 0.3}, {0.4, 0.9, -0.6}, {-0.8, 0.1, 1.5}};
  for (const Shape shape : shapes)
    for (int degree = 1; degree <= 5; ++degree) {
      CAPTURE(std::string(shape_name(shape)));
      CAPTURE(degree);
      const Sample sample = box_mesh(shape, degree, bend);
      const ElementArrays& e = sample.arrays;
      const Eigen::MatrixXd A = A3.topLeftCorner(e.dim, e.dim);
      const Eigen::VectorXd shift = Eigen::Vector3d(1, -2, 3).head(e.dim);
      const Eigen::MatrixXd x = (sample.nodes * A.transpose()).rowwise() + shift.transpose();
      double worst_sum = 0, worst_map = 0;
      for (int p = 0; p < point_count(e); ++p) {
        const Eigen::Map<const Eigen::MatrixXd> g(e.gradients.data() + p * e.nodes_per_element * e.dim, e.dim,
                                                  e.nodes_per_element);
        worst_sum = std::max(worst_sum, g.rowwise().sum().norm() / g.norm());
        worst_map = std::max(worst_map, (deformation(e, p, x) - A).norm());
      }
      CHECK(worst_sum < 1e-14);
      CHECK(worst_map < 1e-13);
    }
}

TEST_CASE("quadratic maps come out exactly on straight quadratic elements") {
  for (const Shape shape : {Shape::quadratic_triangle, Shape::quadratic_tet}) {
    CAPTURE(std::string(shape_name(shape)));
    const Sample sample = box_mesh(shape, 2, same);
    const QuadratureRule rule = quadrature_rule(shape, 2);
    const int last = sample.arrays.dim - 1;
    Eigen::MatrixXd x = sample.nodes;
    x.col(0).array() += 0.3 * sample.nodes.col(last).array().square();
    x.col(last).array() -= 0.4 * sample.nodes.col(0).array() * sample.nodes.col(1).array();
    for (int p = 0; p < point_count(sample.arrays); ++p) {
      const Eigen::VectorXd at = place(shape, rule, sample, p);
      Eigen::MatrixXd F = Eigen::MatrixXd::Identity(last + 1, last + 1);
      F(0, last) += 0.6 * at[last];
      F(last, 0) -= 0.4 * at[1];
      F(last, 1) -= 0.4 * at[0];
      CHECK((deformation(sample.arrays, p, x) - F).norm() < 1e-13);
    }
  }
}

TEST_CASE("area and volume, straight and curved") {
  for (const Shape shape : isoparametric_shapes())
    for (int degree = 1; degree <= 5; ++degree)
      CHECK(total_weight(box_mesh(shape, degree, same).arrays) == doctest::Approx(1).epsilon(1e-14));

  QuadMesh quad{rows<Points2>({0, 0, 2, 0.3, 1.7, 1.9, -0.4, 1.1}), rows<Quads>({0, 1, 2, 3})};
  double shoelace = 0;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    shoelace += 0.5 * (quad.vertices(i, 0) * quad.vertices(j, 1) - quad.vertices(j, 0) * quad.vertices(i, 1));
  }
  CHECK(total_weight(elements(quad)) == doctest::Approx(shoelace).epsilon(1e-14));

  // A parabola over an edge has two thirds of the area of its box.
  auto triangle = quadratic(rows<Points2>({0, 0, 1, 0, 0, 1}), rows<Triangles>({0, 1, 2}));
  triangle.nodes.row(3) << 0.5, -0.15;
  triangle.nodes.row(4).array() += 0.1;
  CHECK(total_weight(elements(triangle)) ==
        doctest::Approx(0.5 + 2.0 / 3 * (0.15 + std::sqrt(2.0) * 0.1 * std::sqrt(2.0))).epsilon(1e-14));

  // Multilinear and quadratic at once, so that every shape has exactly this rest shape; the determinant is of
  // third degree.
  const double c = 0.3;
  const Map swirl = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return x + c * Eigen::Vector3d(x[0] * x[1], x[1] * x[2], x[2] * x[0]);
  };
  const double volume = std::pow(1 + c / 2, 3) + c * c * c / 8;
  for (const Shape shape : {Shape::quadratic_tet, Shape::hex})
    CHECK(total_weight(box_mesh(shape, 3, swirl).arrays) == doctest::Approx(volume).epsilon(1e-13));
}

TEST_CASE("straight quadratic elements share area and gradients with linear ones, far from the origin too") {
  const SurfaceMesh flat = grid(2, 2);
  Points2 plane = flat.vertices.leftCols<2>();
  const ElementArrays linear = elements(plane, flat.triangles);
  const ElementArrays curved = elements(quadratic(plane, flat.triangles), 1);
  REQUIRE(linear.weights.size() == curved.weights.size());
  for (std::size_t t = 0; t < linear.weights.size(); ++t)
    CHECK(curved.weights[t] == doctest::Approx(linear.weights[t]).epsilon(1e-14));

  // Exact in doubles: the same bits.
  HexMesh near = hex_bar(2, 2, 2), far = near;
  far.vertices.array() += 1 << 20;
  CHECK(elements(near).gradients == elements(far).gradients);
  CHECK(elements(near).weights == elements(far).weights);

  // Twice as large: half the gradients.
  ElementArrays scaled = elements(near);
  CHECK(scale_to_total_weight(scaled, 8) == doctest::Approx(2));
  near.vertices *= 2;
  const ElementArrays large = elements(near);
  for (std::size_t i = 0; i < large.gradients.size(); ++i)
    CHECK(scaled.gradients[i] == doctest::Approx(large.gradients[i]).epsilon(1e-14));
}

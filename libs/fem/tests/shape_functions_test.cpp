#include "box_meshes.hpp"
#include "meshes.hpp"

#include <isostretch/fem/quadratic.hpp>
#include <isostretch/fem/shape_functions.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <string>

using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

Eigen::MatrixXd reference_nodes(Shape shape) {
  const TetMesh tet{rows<Points3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}), rows<Tets>({0, 1, 2, 3})};
  const auto triangle = quadratic(rows<Points2>({0, 0, 1, 0, 0, 1}), rows<Triangles>({0, 1, 2}));
  switch (shape) {
    case Shape::triangle:
      return triangle.nodes.topRows(3);
    case Shape::quadratic_triangle:
      return triangle.nodes;
    case Shape::quad:
      return rows<Points2>({0, 0, 1, 0, 1, 1, 0, 1});
    case Shape::tet:
      return tet.vertices;
    case Shape::quadratic_tet:
      return quadratic(tet).nodes;
    case Shape::hex:
      return rows<Points3>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1});
  }
  return {};
}

}  // namespace

TEST_CASE("shape functions: one at their node, zero at the others, and gradients that fit") {
  for (const Shape shape : shapes) {
    CAPTURE(std::string(shape_name(shape)));
    const Eigen::MatrixXd nodes = reference_nodes(shape);
    const int n = shape_node_count(shape), dim = shape_dim(shape);
    REQUIRE(nodes.rows() == n);
    REQUIRE(nodes.cols() == dim);
    Eigen::VectorXd values(n), plus(n), minus(n);
    for (int a = 0; a < n; ++a) {
      const Eigen::VectorXd at = nodes.row(a).transpose();
      shape_values(shape, at.data(), values.data());
      CHECK((values - Eigen::VectorXd::Unit(n, a)).norm() == 0);
    }
    const Eigen::VectorXd at = Eigen::Vector3d(0.21, 0.34, 0.17).head(dim);
    shape_values(shape, at.data(), values.data());
    CHECK(values.sum() == doctest::Approx(1));
    Eigen::MatrixXd gradients(dim, n);
    shape_gradients(shape, at.data(), gradients.data());
    CHECK(gradients.rowwise().sum().norm() < 1e-14);
    for (int d = 0; d < dim; ++d) {
      const Eigen::VectorXd step = 1e-3 * Eigen::VectorXd::Unit(dim, d), up = at + step, down = at - step;
      shape_values(shape, up.data(), plus.data());
      shape_values(shape, down.data(), minus.data());
      // Exact for quadratics.
      CHECK(((plus - minus) / 2e-3 - gradients.row(d).transpose()).norm() < 1e-12);
    }
  }
}

// Quadrature of monomials, on the reference elements and on sheared ones.
#include "box_meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/mesh/structured.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

bool is_simplex(Shape shape) {
  return shape != Shape::quad && shape != Shape::hex;
}

double monomial(const Eigen::VectorXd& x, const int* exponent) {
  double value = 1;
  for (Eigen::Index d = 0; d < x.size(); ++d) value *= std::pow(x[d], exponent[d]);
  return value;
}

// Over the unit square or cube.
double box_integral(int dim, const int* exponent) {
  double value = 1;
  for (int d = 0; d < dim; ++d) value /= exponent[d] + 1;
  return value;
}

double simplex_integral(int dim, const int* exponent) {
  double value = 1;
  int sum = dim;
  for (int d = 0; d < dim; ++d) {
    value *= std::tgamma(exponent[d] + 1);
    sum += exponent[d];
  }
  return value / std::tgamma(sum + 1);
}

// All exponents up to the degree, in total or of each axis.
template <class Body>
void for_each_monomial(int dim, int degree, bool total, const Body& body) {
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      for (int k = 0; k <= (dim == 3 ? degree : 0); ++k) {
        const int exponent[3] = {i, j, k};
        if (!total || i + j + k <= degree) body(exponent);
      }
}

}  // namespace

TEST_CASE("quadrature on the reference elements: inside, positive, exact to the degree") {
  for (const Shape shape : shapes)
    for (int degree = 1; degree <= 5; ++degree) {
      CAPTURE(std::string(shape_name(shape)));
      CAPTURE(degree);
      const QuadratureRule rule = quadrature_rule(shape, degree);
      const int dim = shape_dim(shape);
      REQUIRE(rule.dim == dim);
      REQUIRE(static_cast<int>(rule.points.size()) == dim * rule.size());
      const Eigen::Map<const Eigen::MatrixXd> points(rule.points.data(), dim, rule.size());
      CHECK(points.minCoeff() > 0);
      CHECK((is_simplex(shape) ? points.colwise().sum().maxCoeff() : points.maxCoeff()) < 1);
      for (const double weight : rule.weights) CHECK(weight > 0);
      for_each_monomial(dim, degree, is_simplex(shape), [&](const int* exponent) {
        double sum = 0;
        for (int p = 0; p < rule.size(); ++p)
          sum += rule.weights[static_cast<std::size_t>(p)] * monomial(points.col(p), exponent);
        const double exact =
            is_simplex(shape) ? simplex_integral(dim, exponent) : box_integral(dim, exponent);
        CHECK(std::abs(sum - exact) < 1e-14);
      });
    }
  const int triangle_points[] = {1, 3, 6, 6, 7}, tet_points[] = {1, 4, 8, 14, 14};
  for (int degree = 1; degree <= 5; ++degree) {
    CHECK(quadrature_rule(Shape::triangle, degree).size() == triangle_points[degree - 1]);
    CHECK(quadrature_rule(Shape::quadratic_tet, degree).size() == tet_points[degree - 1]);
  }
  CHECK(quadrature_rule(Shape::quad, 3).size() == 4);
  CHECK(quadrature_rule(Shape::hex, 5).size() == 27);
  CHECK_THROWS_WITH_AS(quadrature_rule(Shape::hex, 6),
                       "no quadrature rule of degree 6 for a hex: there are 1 to 5", Error);
  CHECK_THROWS_WITH_AS(elements(quad_grid(1, 1), 0), doctest::Contains("degree 0"), Error);
}

TEST_CASE("quadrature on affine elements: monomials of the sheared box") {
  const Eigen::Matrix3d shear3{{1.2, 0.3, -0.2}, {0.1, 0.9, 0.4}, {0.2, -0.1, 1.1}};
  for (const Shape shape : isoparametric_shapes())
    for (int degree = 1; degree <= 5; ++degree) {
      CAPTURE(std::string(shape_name(shape)));
      CAPTURE(degree);
      const int dim = shape_dim(shape);
      const Eigen::MatrixXd shear = shear3.topLeftCorner(dim, dim), back = shear.inverse();
      const Sample sample =
          box_mesh(shape, degree, [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return shear * x; });
      const QuadratureRule rule = quadrature_rule(shape, degree);
      for_each_monomial(dim, degree, true, [&](const int* exponent) {
        double sum = 0;
        for (int p = 0; p < point_count(sample.arrays); ++p)
          sum += sample.arrays.weights[static_cast<std::size_t>(p)] *
                 monomial(back * place(shape, rule, sample, p), exponent);
        CHECK(sum == doctest::Approx(shear.determinant() * box_integral(dim, exponent)).epsilon(1e-13));
      });
    }
}

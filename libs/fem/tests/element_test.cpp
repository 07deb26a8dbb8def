// Shape functions, quadrature rules, isoparametric elements, quadratic and structured meshes.
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/fem/shape_functions.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

constexpr Shape shapes[] = {Shape::triangle, Shape::quadratic_triangle, Shape::quad,
                            Shape::tet,      Shape::quadratic_tet,      Shape::hex};

bool is_simplex(Shape shape) {
  return shape != Shape::quad && shape != Shape::hex;
}

// A mesh of any shape: nodes in rows, and its arrays.
struct Sample {
  Eigen::MatrixXd nodes;
  ElementArrays arrays;
};

using Map = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

template <class Points>
void move_nodes(Points& points, const Map& map) {
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = map(Eigen::VectorXd(points.row(i).transpose())).transpose();
}

// The unit square or cube in 2 x 2 (x 2) boxes of that shape, every node moved by the map.
Sample box_mesh(Shape shape, int degree, const Map& map) {
  SurfaceMesh flat = grid(2, 2);
  Points2 plane = flat.vertices.leftCols<2>();
  TetMesh bar = tet_bar(2, 2, 2);
  if (shape == Shape::quad) {
    QuadMesh mesh = quad_grid(2, 2);
    move_nodes(mesh.vertices, map);
    return {mesh.vertices, elements(mesh, degree)};
  }
  if (shape == Shape::hex) {
    HexMesh mesh = hex_bar(2, 2, 2);
    move_nodes(mesh.vertices, map);
    return {mesh.vertices, elements(mesh, degree)};
  }
  if (shape == Shape::quadratic_triangle) {
    QuadraticTriangleMesh mesh = quadratic(plane, flat.triangles);
    move_nodes(mesh.nodes, map);
    return {mesh.nodes, elements(mesh, degree)};
  }
  if (shape == Shape::quadratic_tet) {
    QuadraticTetMesh mesh = quadratic(bar);
    move_nodes(mesh.nodes, map);
    return {mesh.nodes, elements(mesh, degree)};
  }
  if (shape == Shape::triangle) {
    move_nodes(plane, map);
    return {plane, elements(plane, flat.triangles)};
  }
  move_nodes(bar.vertices, map);
  return {bar.vertices, elements(bar)};
}

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

std::vector<Shape> isoparametric_shapes() {
  return {Shape::quadratic_triangle, Shape::quad, Shape::quadratic_tet, Shape::hex};
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

int point_count(const ElementArrays& e) {
  return static_cast<int>(e.weights.size());
}

// Place of a quadrature point by the shape functions.
Eigen::VectorXd place(Shape shape, const QuadratureRule& rule, const Sample& sample, int point) {
  const int n = sample.arrays.nodes_per_element, p = point % rule.size(), e = point / rule.size();
  std::vector<double> values(static_cast<std::size_t>(n));
  shape_values(shape, rule.points.data() + p * rule.dim, values.data());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(rule.dim);
  for (int a = 0; a < n; ++a)
    x += values[static_cast<std::size_t>(a)] *
         sample.nodes.row(sample.arrays.nodes[static_cast<std::size_t>(e * n + a)]).transpose();
  return x;
}

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

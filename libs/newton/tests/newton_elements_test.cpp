// Solves with every kind of element: patch tests and orders of convergence.
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/elements.hpp>
#include <isostretch/fem/quadratic.hpp>
#include <isostretch/fem/shape_functions.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/structured.hpp>
#include <isostretch/newton/minimize.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using mesh::Shape;

namespace {

using Map = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

constexpr Shape shapes[] = {Shape::triangle, Shape::quadratic_triangle, Shape::quad,
                            Shape::tet,      Shape::quadratic_tet,      Shape::hex};

int order_of(Shape shape) {
  return shape == Shape::quadratic_triangle || shape == Shape::quadratic_tet ? 2 : 1;
}

// The unit square or cube, n boxes an axis, of any shape.
struct Patch {
  Shape shape;
  int boxes;
  Map map;
  Eigen::MatrixXd rest;  // a node per row
  std::vector<bool> outside;
  mesh::ElementArrays arrays;

  Patch(Shape s, int n, int degree, Map moved) : shape(s), boxes(n), map(std::move(moved)) {
    if (shape == Shape::triangle || shape == Shape::quadratic_triangle) {
      const auto flat = mesh::grid(n, n);
      mesh::Points2 plane = flat.vertices.leftCols<2>();
      if (shape == Shape::quadratic_triangle) {
        auto curved = mesh::quadratic(plane, flat.triangles);
        adopt(curved.nodes);
        arrays = mesh::elements(curved, degree);
      } else {
        adopt(plane);
        arrays = mesh::elements(plane, flat.triangles);
      }
    } else if (shape == Shape::quad) {
      auto quads = mesh::quad_grid(n, n);
      adopt(quads.vertices);
      arrays = mesh::elements(quads, degree);
    } else if (shape == Shape::hex) {
      auto hexes = mesh::hex_bar(n, n, n);
      adopt(hexes.vertices);
      arrays = mesh::elements(hexes, degree);
    } else if (shape == Shape::quadratic_tet) {
      auto curved = mesh::quadratic(mesh::tet_bar(n, n, n));
      adopt(curved.nodes);
      arrays = mesh::elements(curved, degree);
    } else {
      auto bar = mesh::tet_bar(n, n, n);
      adopt(bar.vertices);
      arrays = mesh::elements(bar);
    }
  }

  int dim() const { return arrays.dim; }

  // At a point of the rule of the arrays, or of any rule for linear elements, which have one point.
  double weight(int e, int p, const mesh::QuadratureRule& rule) const {
    if (arrays.points_per_element > 1)
      return arrays.weights[static_cast<std::size_t>(e * arrays.points_per_element + p)];
    double whole = 0;
    for (const double w : rule.weights) whole += w;
    return arrays.weights[static_cast<std::size_t>(e)] * rule.weights[static_cast<std::size_t>(p)] / whole;
  }

  // Remembers what is on the boundary of the box, then moves all nodes.
  template <class Points>
  void adopt(Points& points) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      outside.push_back(points.row(i).minCoeff() == 0 || points.row(i).maxCoeff() == 1);
      points.row(i) = map(Eigen::VectorXd(points.row(i).transpose())).transpose();
    }
    rest = points;
  }
};

// Vanishes on the boundary of the box; leaves nothing straight, parallel or alike inside.
Eigen::VectorXd irregular(const Eigen::VectorXd& x) {
  Eigen::VectorXd y = x;
  double bubble = 0.4;
  for (Eigen::Index d = 0; d < x.size(); ++d) bubble *= 4 * x[d] * (1 - x[d]);
  for (Eigen::Index d = 0; d < x.size(); ++d)
    y[d] += 0.2 * bubble * std::sin(7 * x[d] + 5 * x[(d + 1) % x.size()] + static_cast<double>(d));
  return y;
}

struct Solved {
  Eigen::MatrixXd x;  // a node per row
  double energy;
};

// The minimum with the boundary at map(rest), from the rest shape inside.
Solved solve(const Patch& patch, const energies::AnyEnergy& energy, const Map& map) {
  const int dim = patch.dim();
  newton::Objective objective(dim, patch.arrays.node_count);
  objective.add<newton::EnergyTerm>(assembly::elements_from(patch.arrays), energy);
  Vector x(patch.rest.size());
  for (int i = 0; i < patch.arrays.node_count; ++i) {
    const Eigen::VectorXd at = patch.rest.row(i).transpose();
    const bool fixed = patch.outside[static_cast<std::size_t>(i)];
    x.segment(dim * i, dim) = fixed ? map(at) : at;
    if (fixed) objective.pin(i);
  }
  newton::Options options;
  options.gradient_tolerance = 1e-12;
  options.scaled_gradient_tolerance = 0;
  const auto summary = newton::minimize(objective, x, options);
  CAPTURE(summary.full_report());
  CHECK(summary.converged());
  Solved solved{patch.rest, summary.energy};
  for (int i = 0; i < patch.arrays.node_count; ++i) solved.x.row(i) = x.segment(dim * i, dim).transpose();
  return solved;
}

// Root of the integral of the square of what differs from the map, at the points of a rule of degree 5.
double l2_error(const Patch& patch, const Eigen::MatrixXd& x, const Map& map) {
  constexpr int degree = 5;
  const auto rule = mesh::quadrature_rule(patch.shape, degree);
  const Patch fine(patch.shape, patch.boxes, degree, patch.map);
  const int n = mesh::shape_node_count(patch.shape);
  Eigen::VectorXd values(n);
  double sum = 0;
  for (int e = 0; e < fine.arrays.element_count(); ++e)
    for (int p = 0; p < rule.size(); ++p) {
      mesh::shape_values(patch.shape, rule.points.data() + p * rule.dim, values.data());
      Eigen::VectorXd rest = Eigen::VectorXd::Zero(rule.dim), at = rest;
      for (int a = 0; a < n; ++a) {
        const int node = fine.arrays.nodes[static_cast<std::size_t>(e * n + a)];
        rest += values[a] * patch.rest.row(node).transpose();
        at += values[a] * x.row(node).transpose();
      }
      sum += fine.weight(e, p, rule) * (at - map(rest)).squaredNorm();
    }
  return std::sqrt(sum);
}

// The power of the element size with which the last two errors fall.
double last_order(const std::vector<double>& errors, const std::vector<int>& boxes) {
  const std::size_t last = errors.size() - 1;
  return std::log(errors[last - 1] / errors[last]) /
         std::log(static_cast<double>(boxes[last]) / boxes[last - 1]);
}

// Every coordinate is harmonic.
Eigen::VectorXd harmonic(const Eigen::VectorXd& x) {
  Eigen::VectorXd y(x.size());
  y[0] = std::exp(x[0]) * std::cos(x[1]);
  y[1] = std::exp(x[1]) * std::sin(x[0]);
  if (x.size() == 3) y[2] = std::exp(2 * x[2]) * std::cos(2 * x[1]) / 4 + x[0] * x[2];
  return y;
}

std::vector<int> refinements(Shape shape) {
  if (mesh::shape_dim(shape) == 2) return {4, 8, 16, 32};
  if (order_of(shape) == 1) return {2, 4, 8, 16};
  return {2, 4, 6, 8};
}

}  // namespace

TEST_CASE("patch test: affine boundary, irregular and curved inside, the affine map everywhere") {
  const Eigen::Matrix3d A3{{1.3, 0.2, -0.1}, {-0.1, 1.2, 0.3}, {0.2, 0.1, 1.4}};
  for (const Shape shape : shapes)
    for (const char* name : {"stable_neo_hookean", "arap"}) {
      CAPTURE(std::string(mesh::shape_name(shape)));
      CAPTURE(name);
      // Curved quadratic tets need degree 3, see elements.hpp.
      const int degree = shape == Shape::quadratic_tet ? 3 : mesh::default_degree(shape);
      const Patch patch(shape, 3, degree, irregular);
      const Eigen::MatrixXd A = A3.topLeftCorner(patch.dim(), patch.dim());
      const auto solved = solve(patch, energies::make_energy(name),
                                [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return A * x; });
      CHECK((solved.x - patch.rest * A.transpose()).cwiseAbs().maxCoeff() < 1e-10);
    }
}

TEST_CASE("patch test: straight quadratic tets pass with the default degree") {
  const Eigen::Matrix3d A{{1.3, 0.2, -0.1}, {-0.1, 1.2, 0.3}, {0.2, 0.1, 1.4}};
  const Map affine = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return A * x; };
  const Patch patch(Shape::quadratic_tet, 2, mesh::default_degree(Shape::quadratic_tet), affine);
  const auto solved = solve(patch, energies::make_energy("stable_neo_hookean"), affine);
  CHECK((solved.x - patch.rest * A.transpose()).cwiseAbs().maxCoeff() < 1e-10);
}

TEST_CASE("harmonic maps: the error falls with the order of the elements plus one") {
  for (const Shape shape : shapes) {
    CAPTURE(std::string(mesh::shape_name(shape)));
    const auto boxes = refinements(shape);
    std::vector<double> errors;
    for (const int n : boxes) {
      const Patch patch(shape, n, mesh::default_degree(shape), irregular);
      errors.push_back(
          l2_error(patch, solve(patch, energies::make_energy("dirichlet"), harmonic).x, harmonic));
      CHECK(errors.back() <= errors.front());
    }
    CHECK(last_order(errors, boxes) >= order_of(shape) + 1 - 0.3);
  }
}

TEST_CASE("a bent beam: the energy approaches that of a fine mesh with twice the order of the elements") {
  const Map beam = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return Eigen::Vector3d(2, 0.8, 0.6).head(x.size()).cwiseProduct(x);
  };
  const Map bend = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    Eigen::VectorXd y = 1.1 * x;
    y[0] = (1.4 - x[1]) * std::sin(0.8 * x[0]);
    y[1] = 1.4 - (1.4 - x[1]) * std::cos(0.8 * x[0]);
    return y;
  };
  const auto energy_of = [&](Shape shape, int n) {
    const Patch patch(shape, n, mesh::default_degree(shape), beam);
    return solve(patch, energies::make_energy("stable_neo_hookean"), bend).energy;
  };
  const double planar = energy_of(Shape::quadratic_triangle, 32), solid = energy_of(Shape::quadratic_tet, 8);
  for (const Shape shape : shapes) {
    CAPTURE(std::string(mesh::shape_name(shape)));
    const bool coarse = shape == Shape::quadratic_tet;  // its next size is that of the reference
    const std::vector<int> boxes = coarse ? std::vector<int>{1, 2, 3, 4} : std::vector<int>{1, 2, 4, 8};
    std::vector<double> errors;
    for (const int n : boxes)
      errors.push_back(std::abs(energy_of(shape, n) - (mesh::shape_dim(shape) == 2 ? planar : solid)));
    CHECK(last_order(errors, boxes) >= 2 * order_of(shape) - 0.3);
  }
}

#include <isostretch/core/error.hpp>
#include <isostretch/fem/quadrature.hpp>

#include <cmath>
#include <string>

namespace isostretch::mesh {
namespace {

constexpr int highest_degree = 5;

void append(QuadratureRule& rule, std::initializer_list<double> point, double weight) {
  rule.points.insert(rule.points.end(), point);
  rule.weights.push_back(weight);
}

// Orbits of barycentric coordinates under all permutations; the last Dim of them are the point.

void append_center(QuadratureRule& rule, double weight) {
  rule.points.insert(rule.points.end(), static_cast<std::size_t>(rule.dim), 1.0 / (rule.dim + 1));
  rule.weights.push_back(weight);
}

// All coordinates a but one: three points of a triangle, four of a tet, towards the corners for small a.
void append_corners(QuadratureRule& rule, double a, double weight) {
  for (int corner = 0; corner <= rule.dim; ++corner) {
    for (int d = 1; d <= rule.dim; ++d) rule.points.push_back(d == corner ? 1 - rule.dim * a : a);
    rule.weights.push_back(weight);
  }
}

// Two coordinates a, two 1/2 - a: six points of a tet, towards the edges for small a.
void append_edges(QuadratureRule& rule, double a, double weight) {
  const double b = 0.5 - a;
  append(rule, {b, a, a}, weight);
  append(rule, {a, b, a}, weight);
  append(rule, {a, a, b}, weight);
  append(rule, {b, b, a}, weight);
  append(rule, {b, a, b}, weight);
  append(rule, {a, b, b}, weight);
}

// Weights as fractions of the area.
QuadratureRule triangle_rule(int degree) {
  QuadratureRule rule{2, {}, {}};
  if (degree == 1) {
    append_center(rule, 1);
  } else if (degree == 2) {
    append_corners(rule, 1.0 / 6, 1.0 / 3);
  } else if (degree <= 4) {
    append_corners(rule, 0.44594849091596488631832925388305, 0.22338158967801146569500700843312);
    append_corners(rule, 0.09157621350977074345957146340220, 0.10995174365532186763832632490021);
  } else {
    const double root = std::sqrt(15.0);
    append_center(rule, 9.0 / 40);
    append_corners(rule, (6 + root) / 21, (155 + root) / 1200);
    append_corners(rule, (6 - root) / 21, (155 - root) / 1200);
  }
  for (double& weight : rule.weights) weight /= 2;
  return rule;
}

// Weights as fractions of the volume. Rules of fewer points exist for degrees 3 to 5; all of these have
// negative weights or points on the boundary.
QuadratureRule tet_rule(int degree) {
  QuadratureRule rule{3, {}, {}};
  if (degree == 1) {
    append_center(rule, 1);
  } else if (degree == 2) {
    append_corners(rule, (5 - std::sqrt(5.0)) / 20, 1.0 / 4);
  } else if (degree == 3) {
    append_corners(rule, 0.3281633025163817, 0.1362178425370870903338);
    append_corners(rule, 0.1080472498984287287651, 0.1137821574629129096662);
  } else {
    append_corners(rule, 0.3108859192633006097973, 0.1126879257180158507992);
    append_corners(rule, 0.0927352503108912264023, 0.0734930431163619495437);
    append_edges(rule, 0.0455037041256496494919, 0.0425460207770814664381);
  }
  for (double& weight : rule.weights) weight /= 6;
  return rule;
}

// Gauss-Legendre on [0, 1].
QuadratureRule line_rule(int degree) {
  QuadratureRule rule{1, {}, {}};
  if (degree == 1) {
    append(rule, {0.5}, 1);
  } else if (degree <= 3) {
    const double offset = std::sqrt(1.0 / 12);
    append(rule, {0.5 - offset}, 0.5);
    append(rule, {0.5 + offset}, 0.5);
  } else {
    const double offset = std::sqrt(3.0 / 20);
    append(rule, {0.5 - offset}, 5.0 / 18);
    append(rule, {0.5}, 4.0 / 9);
    append(rule, {0.5 + offset}, 5.0 / 18);
  }
  return rule;
}

// Every point of `rule` at every height of `line`.
QuadratureRule product(const QuadratureRule& rule, const QuadratureRule& line) {
  QuadratureRule result{rule.dim + 1, {}, {}};
  for (std::size_t k = 0; k < line.weights.size(); ++k)
    for (std::size_t p = 0; p < rule.weights.size(); ++p) {
      const auto* point = rule.points.data() + p * static_cast<std::size_t>(rule.dim);
      result.points.insert(result.points.end(), point, point + rule.dim);
      result.points.push_back(line.points[k]);
      result.weights.push_back(rule.weights[p] * line.weights[k]);
    }
  return result;
}

}  // namespace

QuadratureRule quadrature_rule(Shape shape, int degree) {
  if (degree < 1 || degree > highest_degree)
    throw Error("no quadrature rule of degree " + std::to_string(degree) + " for a " + shape_name(shape) +
                ": there are 1 to " + std::to_string(highest_degree));
  if (shape == Shape::triangle || shape == Shape::quadratic_triangle) return triangle_rule(degree);
  if (shape == Shape::tet || shape == Shape::quadratic_tet) return tet_rule(degree);
  const QuadratureRule line = line_rule(degree), square = product(line, line);
  return shape == Shape::quad ? square : product(square, line);
}

int default_degree(Shape shape) noexcept {
  if (shape == Shape::quad || shape == Shape::hex) return 3;
  return shape == Shape::quadratic_triangle || shape == Shape::quadratic_tet ? 2 : 1;
}

}  // namespace isostretch::mesh

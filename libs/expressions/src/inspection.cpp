#include "inspection.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace isostretch::expressions {
namespace {

using Stretches = std::array<double, 3>;

// Always the same points, all of positive stretches.
std::vector<Stretches> samples(int count) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> exponent(-1.1, 1.1);
  std::vector<Stretches> all{{1, 1, 1}};
  while (static_cast<int>(all.size()) < count)
    all.push_back(
        {std::exp(exponent(generator)), std::exp(exponent(generator)), std::exp(exponent(generator))});
  return all;
}

double variable(Variable which, const Stretches& s, int dim) {
  switch (which) {
    case Variable::I1:
      return s[0] + s[1] + (dim == 3 ? s[2] : 0);
    case Variable::I2:
      return s[0] * s[0] + s[1] * s[1] + (dim == 3 ? s[2] * s[2] : 0);
    case Variable::I3:
      return s[0] * s[1] * (dim == 3 ? s[2] : 1);
    default:
      return s[static_cast<std::size_t>(which) - static_cast<std::size_t>(Variable::s1)];
  }
}

bool same(double a, double b, double scale) {
  constexpr double rounding = 1e-9;
  if (!std::isfinite(a) || !std::isfinite(b)) return std::isfinite(a) == std::isfinite(b);
  return std::abs(a - b) <= rounding * std::max({std::abs(a), std::abs(b), scale});
}

}  // namespace

double Evaluator::operator()(const Stretches& s) {
  values_.resize(graph_.size());
  for (Node node = 0; node <= root_; ++node) {
    const Operation& o = graph_[node];
    values_[node] = o.op == Op::variable ? variable(static_cast<Variable>(o.value), s, dim_)
                                         : apply(o, values_[o.a], values_[o.b], values_[o.c]);
  }
  return values_[root_];
}

bool finite_somewhere(const Graph& graph, Node root, int dim) {
  Evaluator psi(graph, root, dim);
  const auto all = samples(200);
  return std::any_of(all.begin(), all.end(), [&](const Stretches& s) { return std::isfinite(psi(s)); });
}

bool is_symmetric(const Graph& graph, Node root, int dim) {
  Evaluator psi(graph, root, dim);
  double largest = 0;
  for (const Stretches& s : samples(200))
    if (const double value = psi(s); std::isfinite(value)) largest = std::max(largest, std::abs(value));
  for (const Stretches& s : samples(200)) {
    const double value = psi(s);
    if (!same(value, psi({s[1], s[0], s[2]}), 1e-3 * largest)) return false;
    if (dim == 3 && !same(value, psi({s[0], s[2], s[1]}), 1e-3 * largest)) return false;
  }
  return true;
}

bool ends_at_zero_determinant(const Graph& graph, Node root, int dim) {
  constexpr double going_on = 0.7, nothing = 1e-12;
  Evaluator psi(graph, root, dim);
  for (Stretches s : samples(40)) {
    double& smallest = s[static_cast<std::size_t>(dim - 1)];
    const auto at = [&](double value) {
      smallest = value;
      return psi(s);
    };
    if (!std::isfinite(at(1))) continue;
    for (const double inverted : {0.0, -1e-3, -0.1, -0.3})
      if (!std::isfinite(at(inverted))) return true;
    // Of what stays bounded the change dies out with the stretch (of its cubic root to a hundredth); a
    // logarithm changes as much ever after.
    const double far = at(1e-9), near = at(1e-12), nearest = at(1e-15);
    const double early = std::abs(far - at(1e-6)), late = std::abs(nearest - near);
    if (!std::isfinite(nearest)) return true;
    if (late > nothing * std::max(1.0, std::abs(near)) && late > going_on * early) return true;
  }
  return false;
}

}  // namespace isostretch::expressions

// Derivatives of the objective and of the constraint functions that Ipopt and NLopt are given.
#include "../src/constraint_functions.hpp"
#include "../src/objective.hpp"
#include "reference_problems.hpp"

#include <isostretch/baselines/measures.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

namespace {

using namespace isostretch;
using baselines::ConstraintForm;
using baselines::ConstraintFunctions;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

sdp_penalty::Problem problem_named(const std::string& name) {
  for (tests::Reference& reference : tests::references())
    if (reference.name == name) {
      sdp_penalty::Problem problem = std::move(reference.problem);
      problem.margin = 0.05;
      problem.incompressibility = 3;
      problem.alpha = 70;
      for (std::size_t e = 0; e < problem.weights.size(); ++e) problem.weights[e] = 0.5 + 0.1 * double(e % 7);
      problem.targets[1].hard = true;
      return problem;
    }
  FAIL("there is no reference instance ", name);
  return {};
}

const std::string names[] = {"yogurt90_N6_r0.15", "bar3d_squash_8x2x2"};

// No symmetry, and of the size of the body.
std::vector<double> some_unknowns(int count) {
  std::vector<double> x(at(count));
  for (int i = 0; i < count; ++i) x[at(i)] = std::sin(1.7 * i + 0.3 * i * i);
  return x;
}

// Central difference of f along unknown i.
double difference(const std::function<double(const std::vector<double>&)>& f, std::vector<double> x, int i) {
  const double step = 1e-5, middle = x[at(i)];
  x[at(i)] = middle + step;
  const double above = f(x);
  x[at(i)] = middle - step;
  return (above - f(x)) / (2 * step);
}

double norm(const std::vector<double>& v) {
  return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size())).norm();
}

TEST_CASE("The objective's gradient and Hessian are those of the energy") {
  for (const std::string& name : names) {
    CAPTURE(name);
    const sdp_penalty::Problem problem = problem_named(name);
    const baselines::EnergyObjective objective(problem);
    const int n = problem.dim() * problem.node_count(), columns = problem.dim() * (problem.dim() + 1);
    const std::vector<double> x = some_unknowns(n);
    const auto vector = [](const std::vector<double>& v) -> Vector {
      return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
    };
    const auto value = [&](const std::vector<double>& v) { return objective.value(vector(v)); };
    std::vector<double> g(at(n));
    objective.gradient(vector(x), g);
    // A quadratic function: central differences have no error but that of rounding.
    for (int i = 0; i < n; i += 5) CHECK(std::abs(difference(value, x, i) - g[at(i)]) <= 1e-7 * norm(g));

    std::vector<double> H(at(n * n), 0.0);
    for (int i = 0; i < n; ++i) H[at(i * n + i)] = objective.hessian_diagonal(i);
    const ConstraintFunctions functions(problem, ConstraintForm::principal_minors);
    for (int e = 0; e < problem.element_count(); ++e) {
      std::vector<double> block(at(columns * columns), 0.0);
      objective.add_hessian(e, 1, block, columns);
      for (int i = 0; i < columns; ++i)
        for (int j = 0; j < columns; ++j)
          H[at(functions.unknown(e, i) * n + functions.unknown(e, j))] += block[at(i * columns + j)];
    }
    // Exactly g(x) - g(0) = H x.
    std::vector<double> g0(at(n)), Hx(at(n), 0.0), error(at(n));
    objective.gradient(Vector::Zero(n), g0);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) Hx[at(i)] += H[at(i * n + j)] * x[at(j)];
      error[at(i)] = Hx[at(i)] - (g[at(i)] - g0[at(i)]);
    }
    CHECK(norm(error) <= 1e-12 * norm(Hx));
  }
}

void check_derivatives(const sdp_penalty::Problem& problem, ConstraintForm form, bool with_shift) {
  const ConstraintFunctions functions(problem, form, with_shift);
  const int n = functions.unknowns(), columns = functions.columns(), per_element = functions.per_element();
  const std::vector<double> x = some_unknowns(n);
  std::vector<double> J(at(functions.count() * columns));
  functions.jacobian(x, J);
  for (int e = 0; e < problem.element_count(); e += 13) {
    CAPTURE(e);
    const auto row = [&](int k) { return J.data() + at((e * per_element + k) * columns); };
    const auto value_of = [&](int k) {
      return [&, k](const std::vector<double>& v) {
        std::vector<double> c(at(functions.count()));
        functions.values(v, c);
        return c[at(e * per_element + k)];
      };
    };
    std::vector<double> multipliers(at(per_element));
    for (int k = 0; k < per_element; ++k) {
      multipliers[at(k)] = 1 + 0.3 * k;
      const double scale = norm({row(k), row(k) + columns});
      for (int column = 0; column < columns; ++column)
        CHECK(std::abs(difference(value_of(k), x, functions.unknown(e, column)) - row(k)[column]) <=
              1e-6 * scale);
    }

    std::vector<double> H(at(columns * columns), 0.0);
    functions.add_hessian(e, x, multipliers, H);
    for (int i = 0; i < columns; ++i) {
      const auto weighted_gradient = [&](const std::vector<double>& v) {
        std::vector<double> Jv(J.size());
        functions.jacobian(v, Jv);
        double sum = 0;
        for (int k = 0; k < per_element; ++k)
          sum += multipliers[at(k)] * Jv[at((e * per_element + k) * columns + i)];
        return sum;
      };
      for (int j = 0; j < columns; j += 3)
        CHECK(std::abs(difference(weighted_gradient, x, functions.unknown(e, j)) - H[at(i * columns + j)]) <=
              1e-6 * norm(H));
    }
  }
}

TEST_CASE("Constraint functions have the derivatives that they say") {
  for (const std::string& name : names) {
    const sdp_penalty::Problem problem = problem_named(name);
    CAPTURE(name);
    check_derivatives(problem, ConstraintForm::principal_minors, false);
    check_derivatives(problem, ConstraintForm::principal_minors, true);
    if (problem.dim() == 2) check_derivatives(problem, ConstraintForm::second_order_cone, false);
  }
}

TEST_CASE("All functions are positive exactly where the least eigenvalue is above margin and shift") {
  for (const std::string& name : names) {
    CAPTURE(name);
    const sdp_penalty::Problem problem = problem_named(name);
    std::vector<ConstraintForm> forms = {ConstraintForm::principal_minors};
    if (problem.dim() == 2) forms.push_back(ConstraintForm::second_order_cone);
    for (const ConstraintForm form : forms) {
      const ConstraintFunctions functions(problem, form, true);
      std::vector<double> x = some_unknowns(functions.unknowns()), c(at(functions.count()));
      const double least =
          baselines::measure(problem, Eigen::Map<const Vector>(x.data(), functions.unknowns() - 1))
              .min_eigenvalue -
          problem.margin;
      const auto all_positive = [&](double shift) {
        x.back() = shift;
        functions.values(x, c);
        return std::all_of(c.begin(), c.end(), [](double value) { return value > 0; });
      };
      CHECK(all_positive(least - 1e-6));
      CHECK_FALSE(all_positive(least + 1e-6));
    }
  }
}

}  // namespace

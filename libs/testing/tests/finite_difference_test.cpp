#include <isostretch/testing/derivative_checks.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace isostretch::testing;

namespace {

double psi(const Eigen::VectorXd& x) {
  return std::exp(x[0]) * x[1] + x[1] * x[1] * x[1];
}

Eigen::VectorXd gradient(const Eigen::VectorXd& x) {
  return Eigen::Vector2d(std::exp(x[0]) * x[1], std::exp(x[0]) + 3 * x[1] * x[1]);
}

Eigen::VectorXd hessian_times(const Eigen::VectorXd& x, const Eigen::VectorXd& d) {
  const double e = std::exp(x[0]);
  return Eigen::Vector2d(e * x[1] * d[0] + e * d[1], e * d[0] + 6 * x[1] * d[1]);
}

const Eigen::VectorXd point = Eigen::Vector2d(0.3, 1.2);

}  // namespace

TEST_CASE("right derivatives converge at second order") {
  const auto report = check_derivatives(psi, gradient, hessian_times, point);
  CHECK_MESSAGE(report.ok(), report.text());
  CHECK(report.gradient.best_error < 1e-9);
  CHECK(report.gradient.slope == doctest::Approx(2).epsilon(0.05));
  CHECK(report.hessian.slope == doctest::Approx(2).epsilon(0.05));
}

TEST_CASE("a gradient that is wrong in the sixth digit is caught") {
  const auto wrong = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(gradient(x) * (1 + 1e-6)); };
  const auto report = check_derivatives(psi, wrong, hessian_times, point);
  CHECK_FALSE(report.gradient.ok(report.options));
  CHECK(report.text().find("FAILED") != std::string::npos);
}

TEST_CASE("a Hessian with a missing term is caught") {
  const auto wrong = [](const Eigen::VectorXd& x, const Eigen::VectorXd& d) {
    Eigen::VectorXd h = hessian_times(x, d);
    h[1] -= 1e-3 * d[1];
    return h;
  };
  const auto report = check_derivatives(psi, gradient, wrong, point);
  CHECK(report.gradient.ok(report.options));
  CHECK_FALSE(report.hessian.ok(report.options));
}

TEST_CASE("a quadratic has no truncation error to measure a slope on") {
  const auto square = [](const Eigen::VectorXd& x) { return 0.5 * x.squaredNorm(); };
  const auto identity = [](const Eigen::VectorXd& x) { return x; };
  const auto times = [](const Eigen::VectorXd&, const Eigen::VectorXd& d) { return d; };
  const auto report = check_derivatives(square, identity, times, point);
  CHECK_MESSAGE(report.ok(), report.text());
}

TEST_CASE("a kink is not differentiable") {
  const auto kink = [](const Eigen::VectorXd& x) { return std::abs(x[0]) + x[1]; };
  const auto slope = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(Eigen::Vector2d(x[0] < 0 ? -1.0 : 1.0, 1.0));
  };
  const auto none = [](const Eigen::VectorXd& x, const Eigen::VectorXd&) {
    return Eigen::VectorXd(Eigen::VectorXd::Zero(x.size()));
  };
  CHECK_FALSE(check_derivatives(kink, slope, none, Eigen::Vector2d(0.0, 1.0)).ok());
}

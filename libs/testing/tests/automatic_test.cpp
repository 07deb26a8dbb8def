#include <isostretch/testing/automatic_derivatives.hpp>
#include <isostretch/testing/deformation_samples.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace isostretch;
using testing::AutomaticScalar;

namespace {

using Scalar = AutomaticScalar<double, 2>;

// value, gradient and Hessian of f(x, y) against central differences of its values and gradients.
template <class Function>
void check_scalar(Function f, double x, double y) {
  const auto at = [&](double a, double b) { return f(Scalar::variable(a, 0), Scalar::variable(b, 1)); };
  const double h = 1e-5;
  const Scalar s = at(x, y);
  const Scalar steps[2][2] = {{at(x + h, y), at(x - h, y)}, {at(x, y + h), at(x, y - h)}};
  for (int i = 0; i < 2; ++i) {
    CHECK(s.gradient[i] == doctest::Approx((steps[i][0].value - steps[i][1].value) / (2 * h)).epsilon(1e-8));
    for (int j = 0; j < 2; ++j)
      CHECK(s.hessian[i * 2 + j] ==
            doctest::Approx((steps[i][0].gradient[j] - steps[i][1].gradient[j]) / (2 * h)).epsilon(1e-7));
  }
}

// One invariant as an energy.
template <int Which>
struct Invariant {
  template <int Dim, class T>
  T psi(const invariants::Invariants<Dim, T>& I) const {
    return Which == 1 ? I.I1 : Which == 2 ? I.I2 : I.I3;
  }
};

template <int Dim, int Which>
void check_invariant(const Eigen::Matrix<double, Dim, Dim>& F,
                     const Eigen::Matrix<double, Dim, Dim>& gradient,
                     const Eigen::Matrix<double, Dim * Dim, Dim * Dim>& hessian) {
  const auto d = testing::automatic_derivatives<Dim>(Invariant<Which>{}, F);
  CHECK((d.gradient - invariants::vec<Dim>(gradient)).norm() <= 1e-13 * (1 + gradient.norm()));
  CHECK((d.hessian - hessian).norm() <= 1e-12 * (1 + hessian.norm()));
}

template <int Dim>
void check_invariants() {
  int checked = 0;
  for (const auto& sample : testing::deformation_samples<Dim>()) {
    if (!sample.smooth || !sample.moderate) continue;
    ++checked;
    CAPTURE(sample.category);
    check_invariant<Dim, 1>(sample.F, invariants::gradient_I1<Dim>(sample.F),
                            invariants::hessian_I1<Dim>(sample.F));
    check_invariant<Dim, 2>(sample.F, invariants::gradient_I2<Dim>(sample.F),
                            invariants::hessian_I2<Dim>(sample.F));
    check_invariant<Dim, 3>(sample.F, invariants::gradient_I3<Dim>(sample.F),
                            invariants::hessian_I3<Dim>(sample.F));
  }
  CHECK(checked > 10);
}

}  // namespace

TEST_CASE("the automatic scalar differentiates its functions") {
  const auto each = [](auto f) { check_scalar(f, 0.7, 1.9); };
  each([](Scalar x, Scalar y) { return x * y + 2.0 * x - y / 3.0; });
  each([](Scalar x, Scalar y) { return x / y - 1.0 / (x * x); });
  each([](Scalar x, Scalar y) { return sqrt(x * x + y * y); });
  each([](Scalar x, Scalar y) { return cbrt(x * y); });
  each([](Scalar x, Scalar y) { return log(x + y) * exp(x - y); });
  each([](Scalar x, Scalar y) { return log1p(x * y) + expm1(x * y); });
  each([](Scalar x, Scalar y) { return pow(x * y, -1.5); });
  each([](Scalar x, Scalar y) { return abs(x - y) * min(x, y) * max(x * x, y); });
  each([](Scalar x, Scalar y) { return fma(x, y, x) - product_difference(x, x, y, y); });
}

TEST_CASE("implicit differentiation of the largest root gives the rotation and its gradient") {
  check_invariants<2>();
  check_invariants<3>();
}

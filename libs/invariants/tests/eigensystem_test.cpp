#include <isostretch/invariants/eigensystem.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

using namespace isostretch;
using namespace isostretch::invariants;

namespace {

// Generic, inverted, repeated; the rotation is unique. Uniform scaling has a test of its own below.
template <int Dim>
std::vector<MatrixD<Dim>> smooth_matrices() {
  std::vector<MatrixD<Dim>> all;
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  while (all.size() < 20) {
    const MatrixD<Dim> F = MatrixD<Dim>::NullaryExpr([&] { return normal(generator); });
    if (Modes<Dim>(F).stretch().safe_sum(0) > 0.2) all.push_back(F);
  }
  return all;
}

// Zero, rank one, opposite singular values, reflections.
template <int Dim>
std::vector<MatrixD<Dim>> degenerate_matrices() {
  MatrixD<Dim> rank_one = MatrixD<Dim>::Zero(), reflection = MatrixD<Dim>::Identity();
  rank_one(0, Dim - 1) = 2.0;
  reflection(1, 1) = -1.0;
  return {MatrixD<Dim>::Zero(), rank_one, reflection, -2.5 * reflection, 1e-9 * rank_one};
}

template <int Dim>
using Gradient = std::function<MatrixD<Dim>(const MatrixD<Dim>&)>;

// d vec(gradient) / d vec(F) by central differences.
template <int Dim>
MatrixD2<Dim> difference(const Gradient<Dim>& gradient, const MatrixD<Dim>& F) {
  const double h = 1e-5;
  MatrixD2<Dim> H;
  for (int e = 0; e < Dim * Dim; ++e) {
    MatrixD<Dim> up = F, down = F;
    up.data()[e] += h;
    down.data()[e] -= h;
    H.col(e) = vec<Dim>((gradient(up) - gradient(down)) / (2 * h));
  }
  return H;
}

template <int Dim>
void check_gradient(const std::function<double(const Invariants<Dim, double>&)>& value,
                    const Gradient<Dim>& gradient, const MatrixD<Dim>& F) {
  const double h = 1e-5;
  for (int e = 0; e < Dim * Dim; ++e) {
    MatrixD<Dim> up = F, down = F;
    up.data()[e] += h;
    down.data()[e] -= h;
    const double slope =
        (value(invariants::invariants<Dim>(up)) - value(invariants::invariants<Dim>(down))) / (2 * h);
    CHECK(std::abs(gradient(F).data()[e] - slope) < 1e-8);
  }
}

template <int Dim>
void check_derivatives() {
  using I = Invariants<Dim, double>;
  for (const auto& F : smooth_matrices<Dim>()) {
    CAPTURE(F);
    check_gradient<Dim>([](const I& i) { return i.I1; }, gradient_I1<Dim>, F);
    check_gradient<Dim>([](const I& i) { return i.I2; }, gradient_I2<Dim>, F);
    check_gradient<Dim>([](const I& i) { return i.I3; }, gradient_I3<Dim>, F);
    CHECK((hessian_I1<Dim>(F) - difference<Dim>(gradient_I1<Dim>, F)).norm() < 1e-6);
    CHECK((hessian_I2<Dim>(F) - difference<Dim>(gradient_I2<Dim>, F)).norm() < 1e-8);
    CHECK((hessian_I3<Dim>(F) - difference<Dim>(gradient_I3<Dim>, F)).norm() < 1e-8);
  }
}

template <int Dim>
void check_rotation_gradient() {
  const auto polar = [](const MatrixD<Dim>& F) { return MatrixD<Dim>(linalg::polar<Dim>(F).R); };
  for (const auto& F : smooth_matrices<Dim>()) {
    CAPTURE(F);
    CHECK((gradient_I1<Dim>(F) - polar(F)).norm() < 1e-13);
    CHECK((rotation_gradient<Dim>(F) - difference<Dim>(polar, F)).norm() < 1e-6);
  }
}

template <int Dim>
void check_eigenpair(const MatrixD2<Dim>& H, const VectorD2<Dim>& mode, double value) {
  CHECK(mode.norm() == doctest::Approx(1));
  CHECK((H * mode - value * mode).norm() <= 1e-13 * (1 + H.norm()));
}

// I1: 2/(sigma_j + sigma_k) on twists, 0 elsewhere. I3: sigma_i on twist_i, -sigma_i on flip_i; its scaling
// block couples.
template <int Dim>
void check_eigensystems() {
  for (const auto& F : smooth_matrices<Dim>()) {
    CAPTURE(F);
    const Modes<Dim> modes(F);
    const auto s = modes.stretch();
    const auto H1 = hessian_I1<Dim>(F), H2 = hessian_I2<Dim>(F), H3 = hessian_I3<Dim>(F);
    for (int i = 0; i < pair_count<Dim>; ++i) {
      check_eigenpair<Dim>(H1, modes.twist(i), 2 / (s.a(i) + s.b(i)));
      check_eigenpair<Dim>(H1, modes.flip(i), 0);
      check_eigenpair<Dim>(H2, modes.twist(i), 2);
      check_eigenpair<Dim>(H3, modes.twist(i), s.c(i));
      check_eigenpair<Dim>(H3, modes.flip(i), -s.c(i));
      const double coupling = modes.scaling(first<Dim>(i)).dot(H3 * modes.scaling(second<Dim>(i)));
      CHECK(coupling == doctest::Approx(s.c(i)));
    }
    for (int i = 0; i < Dim; ++i) {
      check_eigenpair<Dim>(H1, modes.scaling(i), 0);
      CHECK(std::abs(modes.scaling(i).dot(H3 * modes.scaling(i))) < 1e-13 * (1 + F.norm()));
    }
  }
}

template <int Dim>
void check_modes_orthonormal(const MatrixD<Dim>& F) {
  const Modes<Dim> modes(F);
  MatrixD2<Dim> Q;
  int next = 0;
  for (int i = 0; i < pair_count<Dim>; ++i) Q.col(next++) = modes.twist(i), Q.col(next++) = modes.flip(i);
  for (int i = 0; i < Dim; ++i) Q.col(next++) = modes.scaling(i);
  CHECK((Q.transpose() * Q - MatrixD2<Dim>::Identity()).norm() < 1e-13);
}

template <int Dim>
void check_cauchy_green() {
  for (const auto& F : smooth_matrices<Dim>()) {
    const MatrixD<Dim> C = F.transpose() * F;
    const auto c = cauchy_green<Dim>(invariants::invariants<Dim>(F));
    CHECK(c.I_C == doctest::Approx(C.trace()));
    CHECK(c.II_C == doctest::Approx(C.squaredNorm()));
    CHECK(c.III_C == doctest::Approx(C.determinant()));
  }
}

template <int Dim>
void check_degenerate() {
  for (const auto& F : degenerate_matrices<Dim>()) {
    CAPTURE(F);
    check_modes_orthonormal<Dim>(F);
    CHECK(hessian_I1<Dim>(F).allFinite());
    CHECK(gradient_I1<Dim>(F).allFinite());
    CHECK((gradient_I1<Dim>(F).transpose() * gradient_I1<Dim>(F)).isIdentity(1e-13));
    CHECK(gradient_I1<Dim>(F).determinant() == doctest::Approx(1));
    CHECK(gradient_I3<Dim>(F).allFinite());
    CHECK(hessian_I3<Dim>(F).allFinite());
  }
}

}  // namespace

TEST_CASE("gradients and Hessians of the invariants") {
  check_derivatives<2>();
  check_derivatives<3>();
}

TEST_CASE("the rotation gradient is the derivative of the polar rotation") {
  check_rotation_gradient<2>();
  check_rotation_gradient<3>();
}

TEST_CASE("analytic eigenpairs of the Hessians of the invariants") {
  check_eigensystems<2>();
  check_eigensystems<3>();
}

TEST_CASE("modes are orthonormal") {
  for (const auto& F : smooth_matrices<2>()) check_modes_orthonormal<2>(F);
  for (const auto& F : smooth_matrices<3>()) check_modes_orthonormal<3>(F);
}

TEST_CASE("Cauchy-Green invariants") {
  check_cauchy_green<2>();
  check_cauchy_green<3>();
}

TEST_CASE("degenerate deformation gradients stay finite") {
  check_degenerate<2>();
  check_degenerate<3>();
}

TEST_CASE("the rotation gradient at uniform scaling") {
  const auto polar = [](const MatrixD<3>& F) { return MatrixD<3>(linalg::polar<3>(F).R); };
  for (const double s : {1.0, 1.5}) {
    const MatrixD<3> F = s * MatrixD<3>::Identity();
    CHECK((rotation_gradient<3>(F) - difference<3>(polar, F)).norm() < 1e-6);
  }
}

// Expanded in sigma - 1, the result was off by 1e-10 here.
TEST_CASE("det F - 1 keeps its digits at rest and at any aspect ratio") {
  const PrincipalStretches<2, double> thin{{1e6, 5e-7}};
  CHECK(std::abs(thin.J_minus_one() + 0.5) < 1e-15);
  const PrincipalStretches<3, double> slab{{1e8, 1.0, 5e-9}};
  CHECK(std::abs(slab.J_minus_one() + 0.5) < 1e-15);
  const double e = 0x1p-40;
  const PrincipalStretches<3, double> rest{{1 + 3 * e, 1 + e, 1 - 2 * e}};
  CHECK(rest.J_minus_one() == doctest::Approx(2 * e - 5 * e * e - 6 * e * e * e).epsilon(1e-15));
  const PrincipalStretches<2, double> close{{1 + e, 1 - e}};
  CHECK(close.J_minus_one() == doctest::Approx(-e * e).epsilon(1e-15));
}

TEST_CASE("sigma - product of the others keeps its digits at rest and near zero") {
  const double e = 0x1p-40;
  const PrincipalStretches<3, double> rest{{1 + 2 * e, 1 + e, 1 + e}};
  CHECK(rest.minus_others(0) == doctest::Approx(-e * e).epsilon(1e-15));
  const PrincipalStretches<3, double> tiny{{3e-6, 2e-6, 1e-6}};
  CHECK(tiny.minus_others(0) == doctest::Approx(3e-6 - 2e-12).epsilon(1e-15));
}

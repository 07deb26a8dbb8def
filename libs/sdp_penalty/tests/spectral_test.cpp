// Penalties of eigenvalues: values, slopes and curvatures against finite differences and against each other.
#include "../src/spectral.hpp"
#include "../src/multiplier_method.hpp"
#include "bodies.hpp"
#include "swirl.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace isostretch;
using namespace isostretch::sdp_penalty;

namespace {

class Random {
 public:
  double operator()() { return 2.0 * static_cast<double>(generator_()) / 4294967296.0 - 1; }

 private:
  std::mt19937 generator_{7};
};

Blocks symmetric_blocks(int dim, std::size_t count, double scale, Random& random) {
  const auto d = static_cast<std::size_t>(dim);
  Blocks S(count * d * d);
  for (std::size_t e = 0; e < count; ++e)
    for (std::size_t r = 0; r < d; ++r)
      for (std::size_t c = 0; c <= r; ++c) S[(e * d + r) * d + c] = S[(e * d + c) * d + r] = scale * random();
  return S;
}

SpectralTerm term(Penalty kind, double tau, double offset) {
  SpectralTerm result;
  result.penalty = {kind, tau, offset, nullptr};
  return result;
}

double total(const ConePenalty& penalty, int dim, const Blocks& S) {
  double sum = 0;
  for (const double value : penalty.values(dim, S)) sum += value;
  return sum;
}

double slope_along(const ConePenalty& penalty, int dim, const Blocks& S, const Blocks& direction) {
  PenaltyState state;
  penalty.evaluate(dim, S, state);
  double sum = 0;
  for (std::size_t k = 0; k < S.size(); ++k) sum -= state.multiplier[k] * direction[k];
  return sum;
}

Blocks moved(const Blocks& S, double step, const Blocks& direction) {
  Blocks result = S;
  for (std::size_t k = 0; k < S.size(); ++k) result[k] += step * direction[k];
  return result;
}

// sum h_jk (Q^T dS Q)_jk^2.
double curvature_along(const ConePenalty& penalty, int dim, const Blocks& S, const Blocks& direction) {
  PenaltyState state;
  penalty.evaluate(dim, S, state);
  const auto d = static_cast<std::size_t>(dim);
  double sum = 0;
  for (std::size_t e = 0; e < state.value.size(); ++e) {
    if (!state.curvature.active[e]) continue;
    const double *Q = &state.curvature.Q[e * d * d], *h = &state.curvature.h[e * d * d];
    for (std::size_t j = 0; j < d; ++j)
      for (std::size_t k = 0; k < d; ++k) {
        double entry = 0;
        for (std::size_t r = 0; r < d; ++r)
          for (std::size_t c = 0; c < d; ++c)
            entry += Q[r * d + j] * direction[(e * d + r) * d + c] * Q[c * d + k];
        sum += h[j * d + k] * entry * entry;
      }
  }
  return sum;
}

void check_derivatives(const ConePenalty& penalty, int dim, const Blocks& S, const Blocks& direction) {
  constexpr double step = 1e-5;
  const double slope = slope_along(penalty, dim, S, direction);
  const Blocks ahead = moved(S, step, direction), behind = moved(S, -step, direction);
  CHECK(
      slope ==
      doctest::Approx((total(penalty, dim, ahead) - total(penalty, dim, behind)) / (2 * step)).epsilon(1e-6));
  const double curvature = curvature_along(penalty, dim, S, direction);
  CHECK(curvature >= 0);
  CHECK(curvature == doctest::Approx((slope_along(penalty, dim, ahead, direction) -
                                      slope_along(penalty, dim, behind, direction)) /
                                     (2 * step))
                         .epsilon(2e-4));
}

// G G^T for random G.
Blocks definite_blocks(int dim, std::size_t count, Random& random) {
  const auto d = static_cast<std::size_t>(dim);
  const Blocks G = symmetric_blocks(dim, count, 1, random);
  Blocks U(G.size(), 0.0);
  for (std::size_t e = 0; e < count; ++e)
    for (std::size_t r = 0; r < d; ++r)
      for (std::size_t c = 0; c < d; ++c)
        for (std::size_t k = 0; k < d; ++k)
          U[(e * d + r) * d + c] += G[(e * d + r) * d + k] * G[(e * d + c) * d + k];
  return U;
}

}  // namespace

TEST_CASE("slope and curvature of every penalty agree with finite differences") {
  Random random;
  for (const int dim : {2, 3})
    for (const Penalty kind : all_penalties())
      for (const double tau : {1.0, 50.0}) {
        CAPTURE(dim);
        CAPTURE(penalty_name(kind));
        CAPTURE(tau);
        const Blocks S = symmetric_blocks(dim, 40, kind == Penalty::spline ? 0.3 : 1, random);
        const Blocks direction = symmetric_blocks(dim, 40, 1, random);
        // Away from where the logarithm of the spline ends.
        const SpectralTerm penalty = term(kind, tau, kind == Penalty::spline ? -1.0 : 0.1);
        check_derivatives(penalty, dim, S, direction);
      }
}

TEST_CASE("slope and curvature of the penalties with multipliers agree with finite differences") {
  Random random;
  for (const int dim : {2, 3})
    for (const bool reciprocal : {false, true}) {
      const auto penalty = reciprocal ? reciprocal_penalty() : quadratic_log_penalty();
      CAPTURE(dim);
      CAPTURE(reciprocal);
      penalty->set_multipliers(dim, definite_blocks(dim, 40, random));
      penalty->bound = 0.1;
      penalty->parameter = 5;  // beyond all eigenvalues
      check_derivatives(*penalty, dim, symmetric_blocks(dim, 40, 1, random),
                        symmetric_blocks(dim, 40, 1, random));
      // Deep in the cone the logarithm has taken over.
      Blocks S = symmetric_blocks(dim, 40, 1, random);
      const auto entries = static_cast<std::size_t>(dim * dim), diagonal = static_cast<std::size_t>(dim + 1);
      for (std::size_t k = 0; k < S.size(); ++k)
        if (k % entries % diagonal == 0) S[k] += 30;
      check_derivatives(*penalty, dim, S, symmetric_blocks(dim, 40, 1, random));
    }
}

TEST_CASE("the reciprocal penalty is infinite outside its domain") {
  const auto penalty = reciprocal_penalty();
  penalty->set_multipliers(2, {1, 0, 0, 1});
  penalty->parameter = 0.5;
  CHECK(std::isfinite(penalty->values(2, {-0.49, 0, 0, 1})[0]));
  CHECK(std::isinf(penalty->values(2, {-0.51, 0, 0, 1})[0]));
  CHECK(penalty->least_parameter(-2) == doctest::Approx(4));
}

TEST_CASE("the branches of the spline meet with value, slope and curvature; the printed ones did not") {
  const double tau = 10;
  const SpectralTerm penalty = term(Penalty::spline, tau, 0);
  const auto value = [&](double y) { return penalty.values(2, {y, 0, 0, y})[0] / 2; };
  const double branch = -0.5 / tau;
  CHECK(value(branch - 1e-13) == doctest::Approx(std::log(2.0) / tau));
  CHECK(value(branch + 1e-13) == doctest::Approx(std::log(2.0) / tau));
  const Blocks one{1, 0, 0, 1};
  for (const double side : {-1e-12, 1e-12}) {
    const Blocks S{branch + side, 0, 0, branch + side};
    CHECK(slope_along(penalty, 2, S, one) == doctest::Approx(2 * -2.0));
    CHECK(curvature_along(penalty, 2, S, one) == doctest::Approx(2 * 4 * tau));
  }
}

TEST_CASE("curvature where eigenvalues coincide, or lie on both sides of the branch point") {
  const Blocks shear{0, 1, 1, 0};
  const SpectralTerm quadratic = term(Penalty::quadratic, 5, 0);
  // Two active: 2 tau |dS|^2. One active: 2 tau a / (a - b). None: nothing.
  CHECK(curvature_along(quadratic, 2, {-1, 0, 0, -1}, shear) == doctest::Approx(2 * 5 * 2));
  CHECK(curvature_along(quadratic, 2, {-1, 0, 0, 3}, shear) == doctest::Approx(2 * 5 * 2 * 0.25));
  CHECK(curvature_along(quadratic, 2, {1, 0, 0, 3}, shear) == 0);
  CHECK(std::isfinite(curvature_along(quadratic, 2, {0, 0, 0, 0}, shear)));
  const SpectralTerm cubic = term(Penalty::cubic, 5, 0);
  CHECK(curvature_along(cubic, 2, {-2, 0, 0, -2}, shear) == doctest::Approx(6 * 5 * 2 * 2));
}

TEST_CASE("the element blocks are the Hessian of the spectral term, in 2D and 3D") {
  for (const Problem& problem : {tests::swirl(4, 170), tests::bar_pushed_through()}) {
    const System system(problem);
    Random random;
    Vector x(problem.dim() * problem.node_count()), dx(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = random(), dx[i] = random();
    const SpectralTerm penalty = term(Penalty::quadratic, 3, 0.2);
    Blocks S, dS;
    system.constraints(x, S);
    system.constraints(dx, dS);
    PenaltyState state;
    penalty.evaluate(problem.dim(), S, state);
    REQUIRE(state.active() > 0);
    sparse::SymmetricMatrix matrix = system.quadratic();
    system.assemble_hessian(state.curvature, matrix);
    const double whole = dx.dot(matrix.multiply(dx)), elastic = dx.dot(system.quadratic().multiply(dx));
    CHECK(whole - elastic == doctest::Approx(curvature_along(penalty, problem.dim(), S, dS)).epsilon(1e-10));
    // And the quadratic part is that of the energy.
    Vector g;
    system.gradient(x, g);
    const double change = system.change_of_objective(g, dx, 0.25);
    CHECK(change == doctest::Approx(energy(problem, x + 0.25 * dx) - energy(problem, x)).epsilon(1e-9));
    CHECK(elastic ==
          doctest::Approx(energy(problem, x + dx) + energy(problem, x - dx) - 2 * energy(problem, x))
              .epsilon(1e-9));
  }
}

TEST_CASE("the adjoint of the constraints is one, and the weighted matrix is their form") {
  for (const Problem& problem : {tests::swirl(4, 170), tests::bar_pushed_through()}) {
    System system(problem);
    Random random;
    Vector x(problem.dim() * problem.node_count());
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = random();
    Blocks S;
    system.constraints(x, S);
    const Blocks M = symmetric_blocks(problem.dim(), system.blocks(), 1, random);
    Vector pulled = Vector::Zero(x.size());
    system.add_adjoint(M, pulled);
    double inner = 0;
    for (std::size_t k = 0; k < S.size(); ++k) inner += M[k] * S[k];
    CHECK(pulled.dot(x) == doctest::Approx(inner).epsilon(1e-11));
    sparse::SymmetricMatrix matrix = system.quadratic();
    system.assemble_normal_equations(M, matrix);
    const auto d = static_cast<std::size_t>(problem.dim());
    double form = 0;  // sum tr(M S M S)
    for (std::size_t e = 0; e < system.blocks(); ++e)
      for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) {
          double MS_ij = 0, MS_ji = 0;
          for (std::size_t k = 0; k < d; ++k) {
            MS_ij += M[(e * d + i) * d + k] * S[(e * d + k) * d + j];
            MS_ji += M[(e * d + j) * d + k] * S[(e * d + k) * d + i];
          }
          form += MS_ij * MS_ji;
        }
    CHECK(x.dot(matrix.multiply(x)) - x.dot(system.quadratic().multiply(x)) ==
          doctest::Approx(form).epsilon(1e-10));
  }
}

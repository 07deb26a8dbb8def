// Singular values between bounds, in the frame of the given rotations.
#include "../src/system.hpp"
#include "bodies.hpp"
#include "swirl.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/linalg/decompositions.hpp>
#include <isostretch/sdp_penalty/relinearize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace isostretch;
using sdp_penalty::Problem;
using sdp_penalty::Status;

namespace {

struct Stretches {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
};

template <int D>
Stretches stretches_in(const Problem& problem, const Vector& x) {
  Stretches result;
  const auto& elements = problem.elements;
  for (int e = 0; e < problem.element_count(); ++e) {
    Eigen::Matrix<double, D, D> F = Eigen::Matrix<double, D, D>::Zero();
    for (int a = 0; a <= D; ++a) {
      const auto corner = static_cast<std::size_t>(e * (D + 1) + a);
      for (int r = 0; r < D; ++r)
        for (int c = 0; c < D; ++c)
          F(r, c) += x[D * elements.nodes[corner] + r] *
                     elements.gradients[corner * D + static_cast<std::size_t>(c)];
    }
    const auto svd = linalg::signed_svd<D>(F);
    result.least = std::min(result.least, svd.sigma[D - 1]);
    result.largest = std::max(result.largest, svd.sigma[0]);
  }
  return result;
}

Stretches stretches(const Problem& problem, const Vector& x) {
  return problem.dim() == 2 ? stretches_in<2>(problem, x) : stretches_in<3>(problem, x);
}

}  // namespace

TEST_CASE("singular values stay between the bounds, and the bounds are felt") {
  for (Problem problem : {tests::swirl(16, 120), tests::bar_pushed_through()}) {
    Vector x;
    const auto free = sdp_penalty::solve(problem, x);
    REQUIRE(free.status == Status::optimal);
    const Stretches before = stretches(problem, x);
    problem.margin = 0.2;
    problem.largest_stretch = 1 + 0.6 * (before.largest - 1);
    const auto bounded = sdp_penalty::solve(problem, x);
    CAPTURE(bounded.message);
    CHECK(bounded.status == Status::optimal);
    CHECK(bounded.gap <= 1e-6);
    CHECK(bounded.energy > free.energy);
    const Stretches after = stretches(problem, x);
    CHECK(after.least >= problem.margin);
    CHECK(after.largest <= problem.largest_stretch);
    CHECK(after.largest >= 0.999 * problem.largest_stretch);
    CHECK(bounded.linear_solves <= 25);
  }
}

TEST_CASE("a bound that is far away changes nothing") {
  for (Problem problem : {tests::swirl(12, 150), tests::bar_pushed_through()}) {
    Vector x;
    const auto free = sdp_penalty::solve(problem, x);
    problem.largest_stretch = 1e3;
    const auto bounded = sdp_penalty::solve(problem, x);
    CAPTURE(bounded.message);
    CHECK(bounded.status == Status::optimal);
    CHECK(bounded.energy == doctest::Approx(free.energy).epsilon(2e-6));
  }
}

TEST_CASE("bounds that cannot be had give a defined outcome") {
  Problem problem = tests::bar_pushed_through();
  for (auto& target : problem.targets) target.hard = true;
  problem.largest_stretch = 1.01;
  Vector x;
  const auto summary = sdp_penalty::solve(problem, x);
  CHECK(summary.status != Status::optimal);
  CHECK(x.allFinite());
  CHECK_FALSE(summary.infeasible_elements.empty());
}

TEST_CASE("re-linearised with bounds: distortion stays bounded while the rotations adapt") {
  Problem problem = tests::swirl(10, 90);
  problem.margin = 0.3;
  problem.largest_stretch = 3;
  Vector x;
  const auto summary = sdp_penalty::solve_relinearized(problem, x);
  CHECK(summary.settled);
  const Stretches after = stretches(problem, x);
  CHECK(after.least >= 0.3 - 1e-9);
  CHECK(after.largest <= 3 + 1e-9);
}

TEST_CASE("re-linearised with bounds that cannot be had: penalty solutions, no exception") {
  Problem problem = tests::bar_pushed_through();
  for (auto& target : problem.targets) target.hard = true;
  problem.largest_stretch = 1.5;
  sdp_penalty::RelinearizeOptions options;
  options.max_rounds = 2;
  Vector x;
  const auto summary = sdp_penalty::solve_relinearized(problem, x, options);
  CHECK(summary.rounds.size() == 2);
  CHECK(summary.rounds.front().penalty_solution);
  CHECK(summary.last.status != Status::optimal);
  CHECK(summary.last.energy < std::numeric_limits<double>::infinity());
}

TEST_CASE("the adjoint and the form of what bounds stretch") {
  for (Problem problem : {tests::swirl(4, 170), tests::bar_pushed_through()}) {
    problem.largest_stretch = 2;
    const sdp_penalty::System system(problem);
    std::mt19937 generator(3);
    const auto random = [&] { return 2.0 * static_cast<double>(generator()) / 4294967296.0 - 1; };
    Vector dx(problem.dim() * problem.node_count());
    for (Eigen::Index i = 0; i < dx.size(); ++i) dx[i] = random();
    const sdp_penalty::Blocks B = system.change_of_constrained(dx).stretch;
    const auto n = static_cast<std::size_t>(2 * problem.dim());
    sdp_penalty::Blocks M(B.size());
    for (std::size_t e = 0; e < B.size() / (n * n); ++e)
      for (std::size_t r = 0; r < n; ++r)
        for (std::size_t c = 0; c <= r; ++c) M[(e * n + r) * n + c] = M[(e * n + c) * n + r] = random();
    Vector pulled = Vector::Zero(dx.size());
    system.add_stretch_adjoint(M, pulled);
    double inner = 0, form = 0;
    for (std::size_t k = 0; k < B.size(); ++k) inner += M[k] * B[k];
    CHECK(pulled.dot(dx) == doctest::Approx(inner).epsilon(1e-11));
    for (std::size_t e = 0; e < B.size() / (n * n); ++e) {
      const double *m = &M[e * n * n], *b = &B[e * n * n];
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          double ij = 0, ji = 0;  // of M B
          for (std::size_t k = 0; k < n; ++k)
            ij += m[i * n + k] * b[k * n + j], ji += m[j * n + k] * b[k * n + i];
          form += ij * ji;
        }
    }
    sparse::SymmetricMatrix matrix = system.quadratic();
    system.add_stretch_weighted(M, matrix);
    CHECK(dx.dot(matrix.multiply(dx)) - dx.dot(system.quadratic().multiply(dx)) ==
          doctest::Approx(form).epsilon(1e-10));
  }
}

TEST_CASE("only the interior point bounds stretch, and a bound below the margin is refused") {
  Problem problem = tests::bar_at_rest();
  problem.largest_stretch = 2;
  sdp_penalty::Options options;
  options.method = sdp_penalty::Method::penalty;
  Vector x;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve(problem, x, options),
                       doctest::Contains("method penalty does not know it"), Error);
  problem.margin = 3;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve(problem, x), doctest::Contains("largest_stretch must be above"),
                       Error);
}

// The sequence of convex problems with the rotations of the one before.
#include "bodies.hpp"
#include "swirl.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/relinearize.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace isostretch;
using sdp_penalty::Problem;
using sdp_penalty::RelinearizeOptions;
using sdp_penalty::Status;

namespace {

Problem randomly_rotated(int n, double degrees) {
  Problem problem = tests::swirl(n, 0);
  std::mt19937 generator(5);
  for (int e = 0; e < problem.element_count(); ++e) {
    const double a =
        degrees * std::acos(-1.0) / 180 * (2.0 * static_cast<double>(generator()) / 4294967296.0 - 1);
    double* R = problem.rotations.data() + 4 * e;
    R[0] = R[3] = std::cos(a);
    R[1] = std::sin(a);
    R[2] = -R[1];
  }
  return problem;
}

}  // namespace

TEST_CASE("rounds stay feasible and lower the energy until it settles") {
  for (const Problem& problem : {tests::swirl(12, 120), tests::bar_pushed_through()}) {
    Vector x;
    const auto summary = sdp_penalty::solve_relinearized(problem, x);
    CHECK(summary.settled);
    CHECK(summary.rounds.size() >= 2);
    CHECK(summary.last.inverted == 0);
    for (std::size_t i = 0; i < summary.rounds.size(); ++i) {
      CAPTURE(i);
      CHECK_FALSE(summary.rounds[i].penalty_solution);
      CHECK(summary.rounds[i].inverted == 0);
      if (i > 0) CHECK(summary.rounds[i].energy <= summary.rounds[i - 1].energy * (1 + 1e-6));
    }
  }
}

TEST_CASE("wild ex-rotations are infeasible; the penalty solution leads on to a shape without inversions") {
  const Problem problem = randomly_rotated(8, 180);
  Vector x;
  const auto convex = sdp_penalty::solve(problem, x);
  MESSAGE(convex.message << " " << convex.unreachable_eigenvalue);
  CHECK(convex.status == Status::infeasible);
  CHECK(convex.infeasible_elements.size() == 10);
  CHECK(convex.unreachable_eigenvalue < 1e-2);
  const auto summary = sdp_penalty::solve_relinearized(problem, x);
  CHECK(summary.rounds.front().penalty_solution);
  CHECK(summary.settled);
  CHECK(summary.last.inverted == 0);
  // All targets are at rest: the rest shape is the best there is.
  CHECK(summary.rounds.back().energy < 1e-6);
}

TEST_CASE("rotations that are a little off are no contradiction") {
  Vector x;
  CHECK(sdp_penalty::solve(randomly_rotated(8, 20), x).status == Status::optimal);
}

TEST_CASE("the penalty solution gives way where the constraints cannot be had") {
  Problem problem = tests::bar_pushed_through();
  for (auto& target : problem.targets) {
    target.hard = true;
    // One side farther than the other: pushed evenly, all elements have the same S, whatever the penalty.
    if (target.position[0] < 0) target.position[0] -= target.position[1];
  }
  Vector loose, firm;
  const auto a = sdp_penalty::penalty_solution(problem, loose, 1);
  const auto b = sdp_penalty::penalty_solution(problem, firm, 1e6);
  CHECK(loose.allFinite());
  CHECK(b.min_eigenvalue > a.min_eigenvalue + 0.01);
  CHECK(b.min_eigenvalue < 0);
}

TEST_CASE("nearest rotations are those of the elements, and the callback can end it") {
  const Problem problem = tests::bar_at_rest();
  Vector x;
  sdp_penalty::solve(problem, x);
  for (Eigen::Index i = 0; i + 2 < x.size(); i += 3) {  // a quarter turn about z
    const double before = x[i];
    x[i] = -x[i + 1];
    x[i + 1] = before;
  }
  const auto R = sdp_penalty::nearest_rotations(problem.elements, x);
  for (std::size_t e = 0; e < R.size() / 9; ++e) {
    CHECK(R[9 * e + 1] == doctest::Approx(1));
    CHECK(R[9 * e + 3] == doctest::Approx(-1));
    CHECK(R[9 * e + 8] == doctest::Approx(1));
  }
  int rounds = 0;
  const auto stopped =
      sdp_penalty::solve_relinearized(tests::swirl(8, 90), x, {}, [&](const auto&, const Vector& positions) {
        CHECK(positions.allFinite());
        return ++rounds == 2 ? sdp_penalty::CallbackAction::stop : sdp_penalty::CallbackAction::proceed;
      });
  CHECK(stopped.stopped);
  CHECK(stopped.rounds.size() == 2);
  RelinearizeOptions bad;
  bad.max_rounds = 0;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve_relinearized(problem, x, bad), doctest::Contains("max_rounds"),
                       Error);
}

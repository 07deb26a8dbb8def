// Properties of the interior point on procedural problems.
#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/solver.hpp>

#include "bodies.hpp"
#include "swirl.hpp"

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

using namespace isostretch;
using sdp_penalty::Problem;
using sdp_penalty::Status;
using tests::bar_at_rest;
using tests::swirl;

TEST_CASE("a swirl of half a turn: inversions go, the bound rises to meet the energy") {
  const Problem problem = swirl(20, 150);
  Vector x;
  const auto summary = sdp_penalty::solve(problem, x);
  CAPTURE(summary.message);
  REQUIRE(summary.status == Status::optimal);
  CHECK(summary.trace.front().inverted > 0);
  CHECK(summary.inverted == 0);
  CHECK(summary.min_determinant > 0);
  CHECK(summary.min_eigenvalue >= 0);
  CHECK(summary.gap <= 1e-6);
  CHECK(summary.linear_solves <= 20);
  // The bound is one at every iterate.
  for (const auto& row : summary.trace) CHECK(row.lower_bound <= summary.energy * (1 + 1e-12));
}

TEST_CASE("iterations hardly grow with the resolution") {
  for (const int n : {10, 20, 40, 80}) {
    CAPTURE(n);
    Vector x;
    const auto summary = sdp_penalty::solve(swirl(n, 150), x);
    CHECK(summary.status == Status::optimal);
    CHECK(summary.linear_solves <= 20);
  }
}

TEST_CASE("nothing to do: the minimiser without constraints is returned, in one solve") {
  Vector x;
  const auto summary = sdp_penalty::solve(bar_at_rest(), x);
  CHECK(summary.status == Status::optimal);
  CHECK(summary.iterations == 0);
  CHECK(summary.linear_solves == 1);
  CHECK(summary.energy == doctest::Approx(0).epsilon(1e-20));
  CHECK(summary.min_eigenvalue == doctest::Approx(1));
}

TEST_CASE("a body pressed flat by its targets ends without inversions, with a margin if asked") {
  Problem problem = bar_at_rest();
  for (const double margin : {0.0, 0.1}) {
    problem.margin = margin;
    problem.targets.clear();
    const mesh::TetMesh bar = mesh::tet_bar(4, 2, 2, 2, 1, 1);
    for (int v = 0; v < bar.vertices.rows(); ++v)
      problem.targets.push_back({v, {-0.5 * bar.vertices(v, 0), bar.vertices(v, 1), bar.vertices(v, 2)}});
    Vector x;
    const auto summary = sdp_penalty::solve(problem, x);
    CAPTURE(summary.message);
    CHECK(summary.status == Status::optimal);
    CHECK(summary.min_eigenvalue >= margin);
    CHECK(summary.trace.front().inverted == problem.element_count());
  }
}

TEST_CASE("the callback sees every iterate and can stop") {
  int calls = 0;
  Vector x;
  const auto summary = sdp_penalty::solve(
      swirl(10, 150), x, {}, [&](const sdp_penalty::Iteration& row, const Vector& positions) {
        CHECK(row.iteration == calls++);
        CHECK(positions.allFinite());
        return row.iteration == 3 ? sdp_penalty::CallbackAction::stop : sdp_penalty::CallbackAction::proceed;
      });
  CHECK(summary.status == Status::callback);
  CHECK(summary.iterations == 3);
  CHECK(calls == 4);
}

TEST_CASE("bad problems name what is wrong") {
  const auto refused = [](auto&& spoil, const char* message) {
    Problem problem = bar_at_rest();
    spoil(problem);
    Vector x;
    CHECK_THROWS_WITH_AS(sdp_penalty::solve(problem, x), doctest::Contains(message), Error);
  };
  refused([](Problem& p) { p.rotations[9] = 2; }, "element 1 is not a rotation");
  refused([](Problem& p) { p.rotations[0] = -1; }, "element 0 is not a rotation");
  refused([](Problem& p) { p.rotations.pop_back(); }, "entries of rotations");
  refused([](Problem& p) { p.margin = 1; }, "margin of 1 is not below 1");
  refused([](Problem& p) { p.margin = std::nan(""); }, "margin must not be negative");
  refused([](Problem& p) { p.weights[3] = 0; }, "weight of element 3");
  refused([](Problem& p) { p.targets.clear(); }, "no target holds node 0 or another of its component");
  refused([](Problem& p) { p.targets[2].node = 1000; }, "target 2: node 1000");
  refused([](Problem& p) { p.targets[1].position[0] = std::nan(""); }, "target 1: position");
  refused([](Problem& p) { p.alpha = -1; }, "alpha must not be negative");
  refused([](Problem& p) { p.margin = -1; }, "margin");
  // A second component without a target.
  Problem apart = bar_at_rest();
  apart.elements.node_count += 1;
  Vector x;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve(apart, x),
                       doctest::Contains("node 45, which belongs to no element"), Error);
  sdp_penalty::Options options;
  options.interior_point.step_fraction = 1;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve(bar_at_rest(), x, options), doctest::Contains("step_fraction"),
                       Error);
}

TEST_CASE("energies scaled by a factor take the same iterates") {
  Problem problem = swirl(12, 150);
  Vector x, y;
  const auto one = sdp_penalty::solve(problem, x);
  for (double& weight : problem.weights) weight *= 1e-9;
  problem.alpha *= 1e-9;
  const auto other = sdp_penalty::solve(problem, y);
  CHECK(other.status == Status::optimal);
  CHECK(other.iterations == one.iterations);
  CHECK((x - y).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("centrality corrections save factorizations") {
  int solves[2];
  for (const int corrections : {0, 2}) {
    sdp_penalty::Options options;
    options.interior_point.centrality_corrections = corrections;
    Vector x;
    const auto summary = sdp_penalty::solve(tests::swirl_in_space(5, 180), x, options);
    CHECK(summary.status == Status::optimal);
    solves[corrections / 2] = summary.linear_solves;
  }
  CHECK(solves[1] < solves[0]);
}

TEST_CASE("ex-rotations are set from matrices and stand column by column, as everything else") {
  Problem problem = bar_at_rest();
  Eigen::Matrix3d turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  problem.set_rotations(
      std::vector<Eigen::Matrix3d>(static_cast<std::size_t>(problem.element_count()), turn));
  CHECK(problem.rotations.size() == 9 * static_cast<std::size_t>(problem.element_count()));
  CHECK(Eigen::Map<const Eigen::Matrix3d>(problem.rotations.data() + 9) == turn);
  // The body turned so has no energy but that of its targets.
  Vector x;
  for (sdp_penalty::Target& target : problem.targets) {
    const Eigen::Vector3d turned = turn * Eigen::Map<const Eigen::Vector3d>(target.position.data());
    target.position.assign(turned.begin(), turned.end());
  }
  const auto summary = sdp_penalty::solve(problem, x);
  CHECK(summary.status == Status::optimal);
  CHECK(summary.energy < 1e-12);
}

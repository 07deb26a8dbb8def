// Properties of the interior point on procedural problems.
#include <isostretch/core/error.hpp>
#include <isostretch/mesh/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/sdp_penalty/interior_point.hpp>

#include "swirl.hpp"

#include <doctest/doctest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace isostretch;
using sdp_penalty::Problem;
using sdp_penalty::Status;
using tests::swirl;

namespace {

Problem bar_at_rest() {
  const mesh::TetMesh bar = mesh::tet_bar(4, 2, 2, 2, 1, 1);
  Problem problem;
  problem.elements = assembly::elements_from(mesh::elements(bar));
  problem.weights = sdp_penalty::unit_weights(problem.elements);
  for (int e = 0; e < problem.element_count(); ++e)
    problem.rotations.insert(problem.rotations.end(), {1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (int v = 0; v < bar.vertices.rows(); ++v)
    if (bar.vertices(v, 0) < 0.1)
      problem.targets.push_back({v, {bar.vertices(v, 0), bar.vertices(v, 1), bar.vertices(v, 2)}});
  return problem;
}

}  // namespace

TEST_CASE("a swirl of half a turn: inversions go, the bound rises to meet the energy") {
  const Problem problem = swirl(20, 150);
  Vector x;
  const auto summary = sdp_penalty::solve_interior_point(problem, x);
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
    const auto summary = sdp_penalty::solve_interior_point(swirl(n, 150), x);
    CHECK(summary.status == Status::optimal);
    CHECK(summary.linear_solves <= 20);
  }
}

TEST_CASE("nothing to do: the minimiser without constraints is returned, in one solve") {
  Vector x;
  const auto summary = sdp_penalty::solve_interior_point(bar_at_rest(), x);
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
    const auto summary = sdp_penalty::solve_interior_point(problem, x);
    CAPTURE(summary.message);
    CHECK(summary.status == Status::optimal);
    CHECK(summary.min_eigenvalue >= margin);
    CHECK(summary.trace.front().inverted == problem.element_count());
  }
}

TEST_CASE("results do not depend on the number of threads, bit for bit") {
  const int before = omp_get_max_threads();
  Vector results[2];
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    sdp_penalty::InteriorPointOptions options;
    options.solver.backend = sparse::Backend::eigen_ldlt;  // BLAS may sum differently
    CHECK(sdp_penalty::solve_interior_point(swirl(16, 150), results[threads - 1], options).status ==
          Status::optimal);
  }
  omp_set_num_threads(before);
  CHECK((results[0].array() == results[1].array()).all());
}

TEST_CASE("random ex-rotations: a defined outcome, never a claim of success that is none") {
  for (const double degrees : {20.0, 180.0}) {
    Problem problem = swirl(8, 0);
    std::mt19937 generator(5);
    for (int e = 0; e < problem.element_count(); ++e) {
      const double a =
          degrees * std::acos(-1.0) / 180 * (2.0 * static_cast<double>(generator()) / 4294967296.0 - 1);
      double* R = problem.rotations.data() + 4 * e;
      R[0] = R[3] = std::cos(a);
      R[2] = std::sin(a);
      R[1] = -R[2];
    }
    Vector x;
    const auto summary = sdp_penalty::solve_interior_point(problem, x);
    MESSAGE(degrees << " degrees: " << sdp_penalty::status_name(summary.status) << " " << summary.iterations
                    << " " << summary.energy << " " << summary.gap << " " << summary.min_eigenvalue);
    CHECK(x.allFinite());
    if (summary.status == Status::optimal) {
      CHECK(summary.min_eigenvalue >= 0);
      CHECK(summary.gap <= 1e-6);
    } else {
      CHECK_FALSE(summary.suspects.empty());
    }
  }
}

TEST_CASE("the callback sees every iterate and can stop") {
  int calls = 0;
  Vector x;
  const auto summary = sdp_penalty::solve_interior_point(
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
    CHECK_THROWS_WITH_AS(sdp_penalty::solve_interior_point(problem, x), doctest::Contains(message), Error);
  };
  refused([](Problem& p) { p.rotations[9] = 2; }, "element 1 is not a rotation");
  refused([](Problem& p) { p.rotations[0] = -1; }, "element 0 is not a rotation");
  refused([](Problem& p) { p.rotations.pop_back(); }, "entries of rotations");
  refused([](Problem& p) { p.weights[3] = 0; }, "weight of element 3");
  refused([](Problem& p) { p.targets.clear(); }, "no targets");
  refused([](Problem& p) { p.targets[2].node = 1000; }, "target 2: node 1000");
  refused([](Problem& p) { p.targets[1].position[0] = std::nan(""); }, "target 1: position");
  refused([](Problem& p) { p.alpha = 0; }, "alpha must be positive");
  refused([](Problem& p) { p.margin = -1; }, "margin");
  // A second component without a target.
  Problem apart = bar_at_rest();
  apart.elements.node_count += 1;
  Vector x;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve_interior_point(apart, x), doctest::Contains("targets"), Error);
  sdp_penalty::InteriorPointOptions options;
  options.step_fraction = 1;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve_interior_point(bar_at_rest(), x, options),
                       doctest::Contains("step_fraction"), Error);
}

// What holds for every method, and what a Solver keeps.
#include "bodies.hpp"
#include "swirl.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/solver.hpp>

#include <doctest/doctest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace isostretch;
using sdp_penalty::Method;
using sdp_penalty::Options;
using sdp_penalty::Penalty;
using sdp_penalty::Problem;
using sdp_penalty::Status;

namespace {

Options options_for(Method method, double gap = 1e-5) {
  Options options;
  options.method = method;
  options.gap_tolerance = gap;
  return options;
}

constexpr Method certified_methods[] = {Method::interior_point, Method::augmented_lagrangian,
                                        Method::penalty};

}  // namespace

TEST_CASE("all methods meet at one optimum, and none claims more than it has") {
  for (const Problem& problem : {tests::swirl(12, 150), tests::bar_pushed_through()}) {
    Options best;
    best.gap_tolerance = 1e-8;
    Vector x;
    const auto optimum = sdp_penalty::solve(problem, x, best);
    REQUIRE(optimum.status == Status::optimal);
    for (const Method method : certified_methods) {
      CAPTURE(sdp_penalty::method_name(method));
      Vector other;
      const auto summary = sdp_penalty::solve(problem, other, options_for(method, 3e-5));
      CAPTURE(summary.message);
      CHECK(summary.status == Status::optimal);
      CHECK(summary.inverted == 0);
      CHECK(summary.infeasible == 0);
      CHECK(summary.energy <= optimum.energy * (1 + 3e-5));
      CHECK(summary.energy >= optimum.lower_bound);
      for (const auto& row : summary.trace) CHECK(row.lower_bound <= optimum.energy * (1 + 1e-10));
    }
  }
}

TEST_CASE("the unconstrained minimiser alone is the first row of every method") {
  const Problem problem = tests::swirl(12, 150);
  Vector skinned, x;
  const auto first = sdp_penalty::solve(problem, skinned, options_for(Method::unconstrained));
  CHECK(first.status == Status::path_end);
  CHECK(first.inverted > 0);
  CHECK(std::isnan(first.gap));
  for (const Method method : certified_methods)
    CHECK(sdp_penalty::solve(problem, x, options_for(method)).trace.front().energy == first.energy);
}

TEST_CASE("hard targets are met exactly, and cost what soft ones of great alpha cost") {
  for (Problem problem : {tests::swirl(10, 120), tests::bar_pushed_through()}) {
    Vector x;
    problem.alpha = 1e9;
    const auto soft = sdp_penalty::solve(problem, x, options_for(Method::interior_point));
    for (auto& target : problem.targets) target.hard = true;
    problem.alpha = 0;
    for (const Method method : certified_methods) {
      CAPTURE(sdp_penalty::method_name(method));
      const auto hard = sdp_penalty::solve(problem, x, options_for(method));
      CAPTURE(hard.message);
      if (problem.dim() == 3) {  // pushed through without giving way: nothing is feasible
        CHECK(hard.status != Status::optimal);
        CHECK(hard.infeasible_elements.size() == 10);
      } else {
        CHECK(soft.status == Status::optimal);
        CHECK(hard.status == Status::optimal);
        CHECK(hard.energy == doctest::Approx(soft.energy).epsilon(1e-3));
        CHECK(hard.target_energy == 0);
      }
      for (const auto& target : problem.targets)
        for (int r = 0; r < problem.dim(); ++r)
          CHECK(x[problem.dim() * target.node + r] == target.position[static_cast<std::size_t>(r)]);
    }
  }
}

TEST_CASE("hard targets that no feasible position meets are called infeasible") {
  Problem problem = tests::bar_pushed_through();
  for (auto& target : problem.targets) target.hard = true;
  Vector x;
  const auto summary = sdp_penalty::solve(problem, x);
  CHECK(summary.status == Status::infeasible);
  CHECK(summary.unreachable_eigenvalue < 0);
  CHECK_FALSE(summary.infeasible_elements.empty());
}

TEST_CASE("a handle on every node: hard ones leave nothing to do") {
  Problem problem = tests::bar_at_rest();
  problem.targets.clear();
  const mesh::TetMesh bar = tests::small_bar();
  for (int v = 0; v < bar.vertices.rows(); ++v)
    problem.targets.push_back({v, tests::position_of(bar, v), true});
  Vector x;
  const auto summary = sdp_penalty::solve(problem, x);
  CHECK(summary.status == Status::optimal);
  CHECK(summary.energy == doctest::Approx(0).epsilon(1e-20));
  problem.targets[0].position = {5, 5, 5};  // inverts elements, and nothing can move
  const auto impossible = sdp_penalty::solve(problem, x);
  CHECK(impossible.status != Status::optimal);
  CHECK(impossible.infeasible > 0);
}

TEST_CASE("targets that contradict each other: soft ones meet in the middle, hard ones are refused") {
  Problem problem = tests::bar_at_rest();
  const auto [node, position, hard] = problem.targets[0];
  problem.targets.push_back({node, {position[0], position[1] + 0.02, position[2]}});
  Vector x;
  const auto summary = sdp_penalty::solve(problem, x);
  CHECK(summary.status == Status::optimal);
  CHECK(x[3 * node + 1] == doctest::Approx(position[1] + 0.01).epsilon(0.01));
  problem.targets.front().hard = problem.targets.back().hard = true;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve(problem, x), doctest::Contains("hold node 0 in different places"),
                       Error);
}

TEST_CASE("alpha of 1e12 and of 0") {
  Problem problem = tests::swirl(12, 120);
  Vector x;
  problem.alpha = 1e12;
  const auto stiff = sdp_penalty::solve(problem, x);
  CAPTURE(stiff.message);
  CHECK(stiff.status == Status::optimal);
  CHECK(stiff.inverted == 0);
  problem.alpha = 0;
  CHECK_THROWS_WITH_AS(sdp_penalty::solve(problem, x), doctest::Contains("no target holds node 0"), Error);
}

TEST_CASE("targets out of reach: soft ones give way, without an inverted element") {
  Problem problem = tests::bar_at_rest();
  for (int v = 0; v < 3; ++v) problem.targets.push_back({problem.node_count() - 1 - v, {1e4, -1e4, 1e4}});
  Vector x;
  const auto summary = sdp_penalty::solve(problem, x);
  CAPTURE(summary.message);
  CHECK(summary.status == Status::optimal);
  CHECK(summary.inverted == 0);
}

TEST_CASE("a solver that is used again gives what a new one gives, to the bit, and factorises less") {
  for (const Method method : {Method::interior_point, Method::penalty}) {
    sdp_penalty::Solver solver(options_for(method));
    Vector again, fresh;
    int first = 0;
    for (const double degrees : {90.0, 100.0, 110.0}) {
      const Problem problem = tests::swirl(10, degrees);
      const auto kept = solver.solve(problem, again);
      const auto once = sdp_penalty::solve(problem, fresh, options_for(method));
      CHECK((again.array() == fresh.array()).all());
      CHECK(kept.linear_solves == once.linear_solves - (first++ > 0 ? 1 : 0));
    }
    // Other elements, other handles: whatever was kept is not used.
    const Problem other = tests::bar_pushed_through();
    solver.solve(other, again);
    sdp_penalty::solve(other, fresh, options_for(method));
    CHECK((again.array() == fresh.array()).all());
  }
}

TEST_CASE("the augmented Lagrangian goes on from the drag before, and need not") {
  Options options = options_for(Method::augmented_lagrangian);
  sdp_penalty::Solver warm(options);
  options.augmented_lagrangian.warm_start = false;
  sdp_penalty::Solver cold(options);
  int warm_solves = 0, cold_solves = 0;
  Vector x, y;
  for (const double degrees : {140.0, 145.0, 150.0}) {
    Problem problem = tests::swirl(16, degrees);
    problem.targets.back().hard = true;  // it moves on from drag to drag
    const auto a = warm.solve(problem, x), b = cold.solve(problem, y);
    CHECK(a.status == Status::optimal);
    CHECK(b.status == Status::optimal);
    CHECK(a.energy == doctest::Approx(b.energy).epsilon(2e-5));
    CHECK(x[2 * problem.targets.back().node] == problem.targets.back().position[0]);
    if (degrees > 140) warm_solves += a.linear_solves, cold_solves += b.linear_solves;
  }
  CHECK(warm_solves < cold_solves);
}

TEST_CASE("Algorithm 1 as published runs its whole path") {
  Options options = options_for(Method::penalty);
  options.penalty.as_published = true;
  options.penalty.level_iterations = 60;
  Vector x;
  const auto summary = sdp_penalty::solve(tests::swirl(8, 150), x, options);
  CHECK(summary.trace.back().penalty_factor >= 1e13);
  const auto first = std::find_if(summary.trace.begin(), summary.trace.end(),
                                  [](const auto& row) { return row.penalty_factor > 0; });
  REQUIRE(first != summary.trace.end());
  CHECK(first->penalty_factor == 1);
  CHECK(summary.inverted == 0);
}

TEST_CASE("iterations of penalty methods that end early name the reason") {
  Options options = options_for(Method::penalty);
  options.max_iterations = 3;
  Vector x;
  const auto summary = sdp_penalty::solve(tests::swirl(12, 150), x, options);
  CHECK(summary.status == Status::iterations);
  CHECK(summary.iterations == 3);
  CHECK_FALSE(summary.infeasible_elements.empty());
}

TEST_CASE("every method is the same to the bit for any number of threads") {
  const int before = omp_get_max_threads();
  for (const Method method : certified_methods) {
    Vector results[2];
    for (const int threads : {1, 2}) {
      omp_set_num_threads(threads);
      Options options = options_for(method);
      options.solver.backend = sparse::Backend::eigen_ldlt;  // BLAS may sum differently
      CHECK(sdp_penalty::solve(tests::swirl(24, 120), results[threads - 1], options).status ==
            Status::optimal);
    }
    CHECK((results[0].array() == results[1].array()).all());
  }
  omp_set_num_threads(before);
}

TEST_CASE("ex-rotations of one and of two full turns: certified, or proved to be infeasible") {
  for (const double degrees : {360.0, 720.0})
    for (const Problem& problem : {tests::swirl(12, degrees), tests::swirl_in_space(4, degrees)}) {
      CAPTURE(degrees);
      Vector x;
      const auto summary = sdp_penalty::solve(problem, x);
      CAPTURE(summary.message);
      CHECK(x.allFinite());
      if (summary.status == Status::optimal) {
        CHECK(summary.inverted == 0);
      } else {
        CHECK(summary.status == Status::infeasible);
        CHECK(summary.infeasible_elements.size() == 10);
      }
    }
}

TEST_CASE("a body far from the origin is solved as well as one at the origin") {
  const Problem here = tests::swirl(12, 150);
  Vector x, y;
  const auto near = sdp_penalty::solve(here, x);
  for (const double distance : {1e6, 1e9}) {
    Problem there = here;
    for (auto& target : there.targets)
      for (double& coordinate : target.position) coordinate += distance;
    int calls = 0;
    const auto far = sdp_penalty::solve(there, y, {}, [&](const auto&, const Vector& positions) {
      ++calls;
      CHECK(positions[0] > 0.9 * distance);
      return sdp_penalty::CallbackAction::proceed;
    });
    CHECK(calls > 0);
    CHECK(far.status == Status::optimal);
    CHECK(far.energy == doctest::Approx(near.energy).epsilon(1e-5));
    CHECK((y.array() - distance - x.array()).abs().maxCoeff() < 1e-4 + 1e-15 * distance);
  }
}

TEST_CASE("a bound that rounding has poisoned certifies nothing") {
  Problem problem = tests::swirl(10, 150);
  for (const double alpha : {1e30, 1e60, 1e100}) {
    CAPTURE(alpha);
    problem.alpha = alpha;
    Vector x;
    const auto summary = sdp_penalty::solve(problem, x);
    if (summary.status == Status::optimal) CHECK(summary.lower_bound <= summary.energy * (1 + 1e-9));
  }
}

TEST_CASE("energies that overflow are a failure, and feasible is not claimed") {
  Problem problem = tests::bar_at_rest();
  problem.targets.back().position = {0, -1e200, 0};
  for (const Method method : sdp_penalty::all_methods()) {
    Vector x;
    const auto summary = sdp_penalty::solve(problem, x, options_for(method));
    CHECK(summary.status == Status::failed);
    CHECK_FALSE(summary.feasible());
    CHECK(summary.trace.size() == 1);
  }
}

TEST_CASE("one triangle turned over by hard targets is infeasible") {
  Problem problem = tests::swirl(1, 0);
  problem.targets = {{0, {0, 0}, true}, {1, {-1, 0}, true}, {2, {0, 1}, true}, {3, {-1, 1}, true}};
  Vector x;
  CHECK(sdp_penalty::solve(problem, x).status != Status::optimal);
  problem = tests::bar_pushed_through();
  for (auto& target : problem.targets) target.hard = true;
  const auto summary = sdp_penalty::solve(problem, x);
  CHECK(summary.status == Status::infeasible);
  CHECK(summary.iterations < 40);  // it does not wait for the last
}

TEST_CASE("a gap that rounding cannot close is no failure") {
  Options options;
  options.gap_tolerance = 1e-14;
  Vector x;
  const auto summary = sdp_penalty::solve(tests::swirl(16, 150), x, options);
  CHECK(summary.status != Status::failed);
  CHECK(summary.status != Status::infeasible);
  CHECK(summary.feasible());
  CHECK(summary.gap < 1e-7);
}

TEST_CASE("the penalty path ends at the factor it was given") {
  Options options = options_for(Method::penalty, 1e-15);
  for (const double last : {1.0, 50.0, 1e4}) {
    options.penalty.last = last;
    Vector x;
    CHECK(sdp_penalty::solve(tests::swirl(8, 150), x, options).trace.back().penalty_factor == last);
  }
}

TEST_CASE("names and options") {
  for (const Method method : sdp_penalty::all_methods())
    CHECK(sdp_penalty::method_from_name(sdp_penalty::method_name(method)) == method);
  for (const Penalty penalty : sdp_penalty::all_penalties())
    CHECK(sdp_penalty::penalty_from_name(sdp_penalty::penalty_name(penalty)) == penalty);
  CHECK_THROWS_WITH_AS(sdp_penalty::method_from_name("mosek"), doctest::Contains("there are interior_point"),
                       Error);
  const auto refused = [](auto&& spoil, const char* message) {
    Options options;
    spoil(options);
    CHECK_THROWS_WITH_AS(sdp_penalty::Solver{options}, doctest::Contains(message), Error);
  };
  refused([](Options& o) { o.gap_tolerance = 0; }, "gap_tolerance");
  refused([](Options& o) { o.max_iterations = -1; }, "max_iterations");
  refused([](Options& o) { o.interior_point.step_fraction = 1; }, "step_fraction");
  refused([](Options& o) { o.penalty.factor = 1; }, "penalty.factor");
  refused([](Options& o) { o.penalty.epsilon = std::nan(""); }, "penalty.epsilon");
  refused([](Options& o) { o.augmented_lagrangian.last = 1; }, "augmented_lagrangian.last");
}

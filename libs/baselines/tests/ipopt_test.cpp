#include "general_instances.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace isostretch;
using baselines::Result;
using baselines::Status;
using tests::instance_named;

const std::vector<std::string> ipopt_solvers = {"ipopt", "ipopt_feasible", "ipopt_cone"};

TEST_CASE("Ipopt finds the reference optima, with its iterates as a trace" *
          tests::needs_solvers(ipopt_solvers)) {
  for (const std::string& name : ipopt_solvers) {
    for (const std::string instance : {"yogurt90_N6_r0.15", "bar3d_squash_8x2x2"}) {
      if (name == "ipopt_cone" && instance[0] == 'b') continue;
      CAPTURE(name);
      CAPTURE(instance);
      const double optimum = tests::optimum_of(instance);
      const Result result = baselines::solve(name, instance_named(instance));
      CHECK(result.status == Status::converged);
      CHECK(std::abs(result.measures.energy - optimum) <= 1e-6 * optimum);
      CHECK(result.measures.min_eigenvalue >= -1e-9);
      CHECK(result.measures.inverted == 0);
      CHECK(result.iterations > 5);
      CHECK(result.trace.size() > static_cast<std::size_t>(result.iterations));
      CHECK(std::abs(result.trace.back().measures.energy - result.measures.energy) <= 1e-6 * optimum);
    }
  }
}

TEST_CASE("The search for a feasible start begins outside and comes inside, and its time is modelling" *
          tests::needs_solvers({"ipopt_feasible"})) {
  const Result result = baselines::solve("ipopt_feasible", instance_named("yogurt90_N6_r0.15"));
  CHECK(std::any_of(result.trace.begin() + 1, result.trace.end(),
                    [](const baselines::Point& point) { return point.measures.min_eigenvalue > 0.01; }));
  CHECK(result.trace.front().measures.min_eigenvalue < 0);
  CHECK(result.seconds.modelling > 0);
}

TEST_CASE("Ipopt knows hard targets, weights, incompressibility and the margin" *
          tests::needs_solvers(ipopt_solvers)) {
  const baselines::Instance instance = tests::rich_instance();
  const Result ours = baselines::solve("interior_point", instance);
  REQUIRE(ours.status == Status::converged);
  for (const std::string& name : ipopt_solvers) {
    CAPTURE(name);
    const Result result = baselines::solve(name, instance);
    CHECK(result.status == Status::converged);
    CHECK(std::abs(result.measures.energy - ours.measures.energy) <= 2e-6 * ours.measures.energy);
    CHECK(result.measures.min_eigenvalue >= 0.1 - 1e-8);
    const sdp_penalty::Target& held = instance.problem.targets[0];
    for (int r = 0; r < 2; ++r)
      CHECK(result.x[held.node * 2 + r] == held.position[static_cast<std::size_t>(r)]);
  }
}

TEST_CASE("Cones of three rows are not second-order cones" * tests::needs_solvers({"ipopt_cone"})) {
  const Result result = baselines::solve("ipopt_cone", instance_named("bar3d_squash_8x2x2"));
  CHECK(result.status == Status::not_applicable);
  CHECK_FALSE(result.has_positions());
}

TEST_CASE("Ipopt ends at its limits and where the callback says so, with the positions so far" *
          tests::needs_solvers(ipopt_solvers)) {
  const baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  for (const std::string& name : ipopt_solvers) {
    CAPTURE(name);
    baselines::Options options;
    options.limits.iterations = 3;
    CHECK(baselines::solve(name, instance, options).status == Status::iteration_limit);
    options.limits = {};
    options.stop = StopToken().with_time_limit(1e-9);
    CHECK(baselines::solve(name, instance, options).status == Status::time_limit);
    const Result stopped = tests::check_callback(name, instance, 2);
    CHECK(stopped.trace.size() == 3);
    CHECK(stopped.measures.energy == stopped.trace.back().measures.energy);
  }
}

TEST_CASE("Ipopt does not claim to have solved what cannot be solved" * tests::needs_solvers(ipopt_solvers)) {
  for (const std::string& name : ipopt_solvers) {
    CAPTURE(name);
    const Result result = baselines::solve(name, tests::impossible_instance());
    CAPTURE(result.message);
    CHECK((result.status == Status::claims_infeasible || result.status == Status::stalled));
    CHECK(result.measures.infeasible > 0);
  }
}

}  // namespace

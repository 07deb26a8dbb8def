#include "general_instances.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace isostretch;
using baselines::Result;
using baselines::Status;
using tests::instance_named;

const std::vector<std::string> nlopt_solvers = {"nlopt_mma", "nlopt_ccsaq", "nlopt_slsqp", "nlopt_auglag"};

// As measured, with room. What they say of how they ended is another matter: AUGLAG fails here after it has
// come so far.
void check_optimum(const std::string& name, const baselines::Instance& instance, double optimum) {
  CAPTURE(name);
  const Result result = baselines::solve(name, instance);
  CAPTURE(result.message);
  CHECK(std::abs(result.measures.energy - optimum) <= 3e-5 * optimum);
  CHECK(result.measures.min_eigenvalue >= -1e-3);
  CHECK(result.measures.inverted == 0);
  CHECK(result.iterations > 10);
  CHECK(static_cast<int>(result.trace.size()) == result.iterations);
  for (const sdp_penalty::Target& target : instance.problem.targets)
    for (int r = 0; target.hard && r < 2; ++r)
      CHECK(result.x[target.node * 2 + r] == target.position[static_cast<std::size_t>(r)]);
}

TEST_CASE("Algorithms of NLopt come near the optimum of the smallest reference instance" *
          tests::needs_solvers(nlopt_solvers)) {
  for (const std::string& name : nlopt_solvers)
    check_optimum(name, instance_named("yogurt90_N6_r0.15"), tests::optimum_of("yogurt90_N6_r0.15"));
}

TEST_CASE("NLopt keeps hard targets" * tests::needs_solvers(nlopt_solvers)) {
  baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  instance.problem.targets[0].hard = true;
  const Result ours = baselines::solve("interior_point", instance);
  REQUIRE(ours.status == Status::converged);
  for (const std::string name : {"nlopt_mma", "nlopt_ccsaq"})
    check_optimum(name, instance, ours.measures.energy);
}

TEST_CASE("NLopt ends at its limits and where the callback says so" * tests::needs_solvers(nlopt_solvers)) {
  const baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  for (const std::string& name : nlopt_solvers) {
    CAPTURE(name);
    baselines::Options options;
    options.limits.iterations = 3;
    CHECK(baselines::solve(name, instance, options).status == Status::iteration_limit);
    options.limits = {};
    options.stop = StopToken().with_time_limit(0.01);
    CHECK(baselines::solve(name, instance, options).status == Status::time_limit);
    tests::check_callback(name, instance, 1);
  }
}

TEST_CASE("NLopt's algorithms say what is too large for them" * tests::needs_solvers(nlopt_solvers)) {
  // Many squares beside one another.
  baselines::Instance instance;
  const baselines::Instance square = tests::impossible_instance();
  const int copies = 1600;
  instance = square;
  instance.rest.resize(copies * 8);
  sdp_penalty::Problem& all = instance.problem;
  all.elements.node_count = copies * 4;
  for (int i = 0; i < copies; ++i) {
    instance.rest.segment(8 * i, 8) = square.rest;
    if (i == 0) continue;
    for (const int node : square.problem.elements.nodes) all.elements.nodes.push_back(node + 4 * i);
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(all.elements.gradients, square.problem.elements.gradients);
    append(all.elements.weights, square.problem.elements.weights);
    append(all.rotations, square.problem.rotations);
    append(all.weights, square.problem.weights);
    for (sdp_penalty::Target target : square.problem.targets) {
      target.node += 4 * i;
      all.targets.push_back(target);
    }
  }
  for (const std::string& name : nlopt_solvers) {
    CAPTURE(name);
    const Result result = baselines::solve(name, instance);
    CHECK(result.status == Status::not_applicable);
    CHECK(result.message.find("3200 elements are too many") == 0);
    CHECK_FALSE(result.has_positions());
  }
}

}  // namespace

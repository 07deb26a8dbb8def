#pragma once

// What the tests of general solvers share: instances, and whether a solver is there.
#include "reference_problems.hpp"

#include <isostretch/baselines/solver.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace isostretch::tests {

inline const Reference& reference_named(const std::string& name) {
  static const std::vector<Reference> all = references();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Reference& r) { return r.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

inline baselines::Instance instance_named(const std::string& name) {
  return {reference_named(name).problem, reference_named(name).rest};
}

inline double optimum_of(const std::string& name) {
  return reference_named(name).json["sdp"]["E_upper"];
}

// Decorates a case that runs these solvers, of which programs and libraries need not be installed.
inline RunsUnless needs_solvers(const std::vector<std::string>& names) {
  std::string missing;
  for (const auto& info : baselines::solvers())
    if (std::find(names.begin(), names.end(), info.name) != names.end() && !info.available())
      missing += (missing.empty() ? "" : ", ") + std::string(info.name) + " needs " + std::string(info.needs);
  return RunsUnless(missing);
}

// The callback stops a run at its n-th iterate, which is the result, and what it throws is the run's message.
inline baselines::Result check_callback(const std::string& name, const baselines::Instance& instance, int n) {
  using baselines::Status;
  baselines::Result stopped =
      baselines::solve(name, instance, {}, [n](const baselines::Point& point, const Vector&) {
        return point.iteration == n ? baselines::CallbackAction::stop : baselines::CallbackAction::proceed;
      });
  CHECK(stopped.status == Status::callback);
  CHECK(stopped.has_positions());
  const baselines::Result failed = baselines::solve(
      name, instance, {}, [](const baselines::Point&, const Vector&) -> baselines::CallbackAction {
        throw std::runtime_error("of the callback's own");
      });
  CHECK(failed.status == Status::failed);
  CHECK(failed.message == "of the callback's own");
  return stopped;
}

// A square of two triangles, three of whose corners are held in mirrored places.
inline baselines::Instance impossible_instance() {
  sdp_penalty::Problem problem;
  problem.elements.dim = 2;
  problem.elements.nodes_per_element = 3;
  problem.elements.points_per_element = 1;
  problem.elements.node_count = 4;
  problem.elements.nodes = {0, 1, 2, 0, 2, 3};
  problem.elements.gradients = {-1, 0, 1, -1, 0, 1, 0, -1, 1, 0, -1, 1};
  problem.elements.weights = {0.5, 0.5};
  problem.rotations = {1, 0, 0, 1, 1, 0, 0, 1};
  problem.weights = {1, 1};
  problem.targets = {{0, {0, 0}, true}, {1, {-1, 0}, true}, {2, {-1, 1}, true}};
  baselines::Instance instance{problem, Vector(8)};
  instance.rest << 0, 0, 1, 0, 1, 1, 0, 1;
  return instance;
}

// The optimum of another one, with all that a problem may have but a bound on stretch, is as our own method
// finds it.
inline baselines::Instance rich_instance() {
  baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  sdp_penalty::Problem& problem = instance.problem;
  problem.margin = 0.1;
  problem.incompressibility = 3;
  for (std::size_t e = 0; e < problem.weights.size(); ++e) problem.weights[e] = 0.5 + 0.1 * double(e % 7);
  problem.targets[0].hard = true;
  return instance;
}

}  // namespace isostretch::tests

#include "general_instances.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/core/error.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <set>

namespace {

using namespace isostretch;
using baselines::Status;
using tests::instance_named;

TEST_CASE("Solvers have names of their own, and an unknown one is refused with the list") {
  std::set<std::string_view> names;
  for (const auto& info : baselines::solvers()) {
    CHECK(names.insert(info.name).second);
    CHECK_FALSE(info.title.empty());
    CHECK_FALSE(info.source.empty());
  }
  CHECK_THROWS_WITH_AS(baselines::solve("mosek", instance_named("yogurt90_N6_r0.15")),
                       doctest::Contains("there is no solver 'mosek', there are: interior_point"), Error);
}

// Returns how many instances were small enough.
int check_own_methods(const std::vector<tests::Reference>& references) {
  int checked = 0;
  for (const tests::Reference& reference : references) {
    if (reference.problem.element_count() > 1000) continue;
    ++checked;
    CAPTURE(reference.name);
    const double optimum = reference.json["sdp"]["E_upper"];
    for (const char* name : {"interior_point", "penalty", "augmented_lagrangian"}) {
      CAPTURE(name);
      const auto result = baselines::solve(name, {reference.problem, reference.rest});
      CHECK(result.status == Status::converged);
      CHECK(std::abs(result.measures.energy - optimum) <= 2e-6 * optimum);
      CHECK(result.lower_bound <= optimum * (1 + 1e-9));
      CHECK(result.measures.infeasible == 0);
      CHECK(result.measures.inverted == 0);
      CHECK(result.measures.min_determinant > 0);
      CHECK(result.measures.distortion <= result.measures.energy);
      REQUIRE(result.trace.size() == static_cast<std::size_t>(result.iterations) + 1);
      CHECK(result.trace.back().measures.energy == result.measures.energy);
      CHECK(result.seconds.solving > 0);
    }
  }
  return checked;
}

TEST_CASE("Own methods find the reference optima, with a trace, a bound and every phase's seconds") {
  CHECK(check_own_methods(tests::references()) == 3);
}

TEST_CASE("Own methods find the outside optima" * tests::outside_data({"sdp"})) {
  CHECK(check_own_methods(tests::outside_references()) == 5);
}

TEST_CASE("Limits and the callback end a run with statuses of their own") {
  const baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  baselines::Options options;
  options.stop = StopToken().with_time_limit(1e-9);
  CHECK(baselines::solve("penalty", instance, options).status == Status::time_limit);
  options = {};
  options.limits = {.iterations = 2};
  const auto limited = baselines::solve("penalty", instance, options);
  CHECK(limited.status == Status::iteration_limit);
  CHECK(limited.iterations == 2);
  const auto stopped =
      baselines::solve("penalty", instance, {}, [](const baselines::Point& point, const Vector&) {
        return point.iteration == 1 ? baselines::CallbackAction::stop : baselines::CallbackAction::proceed;
      });
  CHECK(stopped.status == Status::callback);
  options = {};
  const StopSource source;
  options.stop = source.token();
  int seen = 0;
  const auto told = baselines::solve("penalty", instance, options, [&](const auto&, const Vector&) {
    if (++seen == 3) source.request_stop();
    return baselines::CallbackAction::proceed;
  });
  CHECK(told.status == Status::callback);
  CHECK(told.trace.size() == 3);
  CHECK(stopped.iterations == 1);
  CHECK(stopped.has_positions());
}

TEST_CASE("An invalid instance or option is refused by name") {
  baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  baselines::Options options;
  options.tolerance = 0;
  CHECK_THROWS_WITH_AS(baselines::solve("penalty", instance, options), doctest::Contains("tolerance"), Error);
  options = {};
  options.limits.megabytes = -1;
  CHECK_THROWS_WITH_AS(baselines::solve("penalty", instance, options), doctest::Contains("limits.megabytes"),
                       Error);
  const double x = instance.rest[0];
  instance.rest[0] = std::nan("");
  CHECK_THROWS_WITH_AS(baselines::solve("penalty", instance), doctest::Contains("at rest is not finite"),
                       Error);
  instance.rest[0] = x;
  for (int i = 0; i < instance.rest.size(); i += 2) instance.rest[i] = -instance.rest[i];
  CHECK_THROWS_WITH_AS(baselines::solve("penalty", instance),
                       doctest::Contains("element 0 is inverted or flat at rest"), Error);
}

TEST_CASE("Positions that are not finite have no energy and every element inverted") {
  const baselines::Instance instance = instance_named("yogurt90_N6_r0.15");
  Vector x = instance.rest;
  x[3] = std::numeric_limits<double>::infinity();
  const auto measures = baselines::measure(instance.problem, x);
  CHECK(std::isnan(measures.energy));
  CHECK(measures.inverted == instance.problem.element_count());
}

}  // namespace

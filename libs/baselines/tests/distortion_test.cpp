#include "distortion_problems.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

using namespace isostretch;
using baselines::DistortionProblem;
using baselines::MethodOptions;

namespace {

bool applies(const baselines::MethodInfo& method, const DistortionProblem& problem) {
  return baselines::why_not_applicable(method.name, problem).empty();
}

// Every method that takes the problem reaches the energy of ours, from the same start.
void check_same_optimum(const tests::Started& started, const MethodOptions& options, double tolerance) {
  Vector reference = started.start;
  const newton::Summary best = baselines::minimize("isostretch", started.problem, reference, options);
  REQUIRE(best.converged());
  int checked = 0;
  for (const baselines::MethodInfo& method : baselines::methods()) {
    if (!applies(method, started.problem)) continue;
    ++checked;
    CAPTURE(method.name);
    Vector x = started.start;
    const newton::Summary summary = baselines::minimize(method.name, started.problem, x, options);
    CAPTURE(summary.message);
    CHECK(summary.converged());
    CHECK(summary.energy == doctest::Approx(best.energy).epsilon(tolerance));
    CHECK(summary.trace.front().energy == best.trace.front().energy);
  }
  CHECK(checked > 5);
}

}  // namespace

TEST_SUITE("distortion") {
  TEST_CASE("names of methods are unique, and an unknown one lists them") {
    std::set<std::string_view> names;
    for (const auto& method : baselines::methods()) {
      CHECK(names.insert(method.name).second);
      CHECK(!method.title.empty());
      CHECK(!method.source.empty());
    }
    auto started = tests::flattening(energies::make_energy("symmetric_dirichlet"));
    CHECK_THROWS_WITH_AS(baselines::minimize("gradient_descent", started.problem, started.start),
                         doctest::Contains("isostretch, analytic"), Error);
  }

  TEST_CASE("problems and options that make no sense are refused by name") {
    auto started = tests::flattening(energies::make_energy("symmetric_dirichlet"));
    started.problem.pinned = {0, -1};
    CHECK_THROWS_WITH_AS(baselines::minimize("analytic", started.problem, started.start),
                         doctest::Contains("pin 1: node -1"), Error);
    started.problem.pinned = {};
    MethodOptions options;
    options.time_limit = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(baselines::minimize("analytic", started.problem, started.start, options),
                         doctest::Contains("time_limit"), Error);
    Vector short_start = started.start.head(4);
    CHECK_THROWS_WITH_AS(baselines::minimize("analytic", started.problem, short_start),
                         doctest::Contains("the start has 4 entries"), Error);
    started.problem.energy = energies::make_energy("mips_3d");
    CHECK_THROWS_WITH_AS(baselines::why_not_applicable("analytic", started.problem),
                         doctest::Contains("does not exist in 2D"), Error);
  }

  TEST_CASE("all methods flatten a cap to the same energy") {
    MethodOptions options;
    options.gradient_tolerance = 1e-6;
    options.max_iterations = 5000;
    for (const char* energy : {"symmetric_dirichlet", "symmetric_arap"}) {
      CAPTURE(energy);
      check_same_optimum(tests::flattening(energies::make_energy(energy)), options, 1e-8);
    }
  }

  TEST_CASE("all methods twist a bar to the same energy") {
    MethodOptions options;
    options.gradient_tolerance = 1e-6;
    options.max_iterations = 5000;
    for (const char* energy : {"symmetric_dirichlet", "arap", "stable_neo_hookean"}) {
      CAPTURE(energy);
      check_same_optimum(tests::twisted_bar(energies::make_energy(energy)), options, 1e-8);
    }
  }

  TEST_CASE("limits end every method, and the trace says how far it came") {
    const auto started = tests::flattening(energies::make_energy("symmetric_dirichlet"));
    int checked = 0;
    for (const auto& method : baselines::methods()) {
      if (!applies(method, started.problem)) continue;
      ++checked;
      CAPTURE(method.name);
      MethodOptions options;
      options.gradient_tolerance = 0;
      options.max_iterations = 2;
      Vector x = started.start;
      const auto summary = baselines::minimize(method.name, started.problem, x, options);
      CHECK(summary.status == newton::Status::stopped_iterations);
      CHECK(summary.iterations == 2);
      REQUIRE(summary.trace.size() == 3);
      CHECK(summary.trace.back().energy == summary.energy);
      CHECK(summary.energy < summary.initial_energy);
      Vector y = started.start;
      const auto stopped = baselines::minimize(
          method.name, started.problem, y, options, [](const newton::Iteration& row, const Vector&) {
            return row.iteration == 1 ? newton::CallbackAction::stop : newton::CallbackAction::proceed;
          });
      CHECK(stopped.status == newton::Status::stopped_by_callback);
      CHECK(stopped.iterations == 1);
    }
    CHECK(checked > 5);
  }
}

// Formulations of inversion-free manipulation other than the convex problem.
#include "../src/nearest_matrix_term.hpp"
#include "general_instances.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/newton/objective.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace isostretch;
using baselines::Kind;
using baselines::Status;
using tests::reference_named;

// A pattern of its own kind in every entry.
Vector wobbled(Vector x, double size) {
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += size * std::sin(1.7 * static_cast<double>(i));
  return x;
}

// Returns how many instances were small enough.
int check_nearest_matrix_term(std::vector<tests::Reference> references) {
  int checked = 0;
  for (tests::Reference& reference : references) {
    if (reference.problem.element_count() > 400) continue;
    ++checked;
    CAPTURE(reference.name);
    sdp_penalty::Problem& problem = reference.problem;
    problem.incompressibility = 3;
    const Vector x = wobbled(reference.rest, 0.05), dx = wobbled(Vector::Zero(x.size()), 0.1);
    newton::Objective objective(problem.dim(), problem.node_count());
    auto& term = objective.add<baselines::NearestMatrixTerm>(problem);
    const double energy = sdp_penalty::energy(problem, x) - sdp_penalty::target_energy(problem, x);
    CHECK(term.value(x).value == doctest::Approx(energy).epsilon(1e-12));
    Vector gradient = Vector::Zero(x.size());
    objective.differentiate(x, {}, gradient, true);
    sparse::SymmetricMatrix hessian = objective.zero_matrix();
    objective.hessian(hessian);
    // Quadratic: differences are exact but for rounding.
    const double ahead = term.value(x + dx).value, behind = term.value(x - dx).value;
    CHECK(gradient.dot(dx) == doctest::Approx(0.5 * (ahead - behind)).epsilon(1e-10));
    CHECK(dx.dot(hessian.multiply(dx)) == doctest::Approx(ahead + behind - 2 * energy).epsilon(1e-10));
  }
  return checked;
}

TEST_CASE("The term of nearest matrices is the elastic energy of the convex problem, with its derivatives") {
  CHECK(check_nearest_matrix_term(tests::references()) == 3);
}

TEST_CASE("The term of nearest matrices on outside instances" * tests::outside_data({"sdp"})) {
  CHECK(check_nearest_matrix_term(tests::outside_references()) == 3);
}

// Returns how many of the two-dimensional instances in question are among these.
int check_formulations(const std::vector<tests::Reference>& references) {
  int checked = 0;
  for (const tests::Reference& reference : references) {
    if (reference.name != "pinch_N4" && reference.name != "yogurt90_N6_r0.15" &&
        reference.name != "yogurt180_N10_r0.1")
      continue;
    ++checked;
    for (const auto& info : baselines::solvers()) {
      if (info.kind == Kind::convex) continue;
      CAPTURE(reference.name);
      CAPTURE(info.name);
      const auto result = baselines::solve(info.name, {reference.problem, reference.rest});
      if (result.status == Status::not_applicable) {
        CHECK(info.name == "lifted_content");
        CHECK_FALSE(result.has_positions());
        continue;
      }
      CHECK(result.status == Status::converged);
      CHECK(result.measures.inverted == 0);
      CHECK(result.measures.min_determinant > 0);
      CHECK(result.trace.size() > 1);
      CHECK(result.linear_solves != 0);
      MESSAGE(info.name << " on " << reference.name << ": " << result.iterations << " iterations, distortion "
                        << result.measures.distortion << ", " << result.seconds.total() << " s");
    }
  }
  return checked;
}

TEST_CASE("Each formulation ends without inverted elements where there were some, and says so") {
  CHECK(check_formulations(tests::references()) == 2);
}

TEST_CASE("Each formulation ends without inverted elements on an outside instance" *
          tests::outside_data({"sdp"})) {
  CHECK(check_formulations(tests::outside_references()) == 1);
}

TEST_CASE("Locally injective mappings never leave the inversion-free positions, and end below the start") {
  const tests::Reference reference = reference_named("pinch_N4");
  const auto result = baselines::solve("locally_injective", {reference.problem, reference.rest});
  for (const auto& point : result.trace) CHECK(point.measures.inverted == 0);
  CHECK(result.measures.energy < result.trace.front().measures.energy);
  // Without the convex constraint, which asks for more than no inversions, it may be better than that
  // optimum, but not than the minimum without any.
  CHECK(result.measures.energy >= reference.json["unconstrained"]["E"].get<double>() * (1 - 1e-9));
}

TEST_CASE("Bounded distortion ends in the convex problem's feasible set with the targets where they belong") {
  const tests::Reference reference = reference_named("pinch_N4");
  const auto result = baselines::solve("bounded_distortion", {reference.problem, reference.rest});
  REQUIRE(result.status == Status::converged);
  CHECK(result.measures.infeasible == 0);
  CHECK(result.measures.target_energy < 1e-20);
  CHECK(result.linear_solves == 2);
  CHECK(result.measures.energy >= reference.json["sdp"]["E_lower"].get<double>() * (1 - 1e-9));
}

TEST_CASE("Re-linearised rounds lower the distortion that the convex problem leaves") {
  const tests::Reference reference = reference_named("pinch_N4");
  const baselines::Instance instance{reference.problem, reference.rest};
  const auto convex = baselines::solve("interior_point", instance);
  const auto rounds = baselines::solve("relinearized", instance);
  const auto total = [](const baselines::Result& r) {
    return r.measures.distortion + r.measures.target_energy;
  };
  CHECK(total(rounds) < total(convex));
}

TEST_CASE(
    "Limits hold for other formulations, too, and a bound on stretch that one does not know is refused") {
  const tests::Reference reference = reference_named("pinch_N4");
  baselines::Instance instance{reference.problem, reference.rest};
  for (const auto& info : baselines::solvers()) {
    if (info.kind == Kind::convex) continue;
    CAPTURE(info.name);
    baselines::Options options;
    options.limits.iterations = 1;
    const auto limited = baselines::solve(info.name, instance, options);
    CHECK((limited.status == Status::iteration_limit || limited.status == Status::converged ||
           limited.status == Status::not_applicable));
    CHECK(limited.iterations <= 1);
    options.limits = {};
    options.stop = StopToken().with_time_limit(1e-9);
    const auto timed = baselines::solve(info.name, instance, options);
    CHECK((timed.status == Status::time_limit || timed.status == Status::not_applicable));
    if (info.bounds_stretch) continue;
    baselines::Instance bounded = instance;
    bounded.problem.largest_stretch = 3;
    CHECK(baselines::solve(info.name, bounded).status == Status::not_applicable);
  }
}

}  // namespace

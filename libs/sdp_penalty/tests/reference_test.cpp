// The reference instances of the inversion-free problem, whose optima are bracketed to 1e-10.
#include "reference_problems.hpp"

#include <isostretch/sdp_penalty/solver.hpp>

#include <doctest/doctest.h>

using namespace isostretch;
using sdp_penalty::Method;
using sdp_penalty::Options;
using sdp_penalty::Penalty;
using sdp_penalty::Status;
using sdp_penalty::Summary;

namespace {

void report(const std::string& name, const Summary& summary) {
  MESSAGE(name << ": " << sdp_penalty::status_name(summary.status) << ", " << summary.iterations
               << " iterations, " << summary.linear_solves << " solves, energy " << summary.energy << ", gap "
               << summary.gap << ", " << summary.min_eigenvalue << ", " << summary.seconds << " s");
}

}  // namespace

static void check_interior_point(const std::vector<tests::Reference>& references) {
  for (const auto& [key, json, reference, rest] : references) {
    const std::string& name = key;
    sdp_penalty::Problem problem = reference;
    for (const std::string kind : {"sdp", "sdp_eps"}) {
      CAPTURE(name);
      CAPTURE(kind);
      problem.margin = kind == "sdp" ? 0.0 : 1e-6;
      Options options;
      options.gap_tolerance = 1e-8;
      Vector x;
      const Summary summary = sdp_penalty::solve(problem, x, options);
      const double lower = json[kind]["E_lower"], upper = json[kind]["E_upper"];
      report(name + " " + kind, summary);
      CHECK(summary.status == Status::optimal);
      CHECK(summary.energy >= lower * (1 - 1e-9));
      CHECK(summary.energy <= upper * (1 + 2e-8));
      CHECK(summary.lower_bound <= upper * (1 + 1e-9));
      CHECK(summary.min_eigenvalue >= problem.margin);
      CHECK(summary.inverted == 0);
      CHECK(summary.trace.front().energy ==
            doctest::Approx(json["unconstrained"]["E"].get<double>()).epsilon(1e-9));
      CHECK(summary.linear_solves <= 20);
    }
  }
}

TEST_CASE("reference optima: interior point, both margins") {
  check_interior_point(tests::references());
}

TEST_CASE("outside optima: interior point, both margins" * tests::outside_data({"sdp"})) {
  check_interior_point(tests::outside_references());
}

static void check_penalty_path(const std::vector<tests::Reference>& references) {
  for (const auto& [key, json, problem, rest] : references)
    for (const Penalty penalty : sdp_penalty::all_penalties()) {
      const std::string& name = key;
      CAPTURE(name);
      CAPTURE(sdp_penalty::penalty_name(penalty));
      Options options;
      options.method = Method::penalty;
      options.penalty.penalty = penalty;
      Vector x;
      const Summary summary = sdp_penalty::solve(problem, x, options);
      report(name + " " + std::string(sdp_penalty::penalty_name(penalty)), summary);
      const double lower = json["sdp"]["E_lower"], upper = json["sdp"]["E_upper"];
      CHECK(summary.status == Status::optimal);
      CHECK(summary.energy >= lower * (1 - 1e-9));
      CHECK(summary.energy <= upper * (1 + 1e-6));
      CHECK(summary.inverted == 0);
    }
}

TEST_CASE("reference optima: the penalty path, certified, whichever the penalty") {
  check_penalty_path(tests::references());
}

TEST_CASE("outside optima: the penalty path, certified, whichever the penalty" *
          tests::outside_data({"sdp"})) {
  check_penalty_path(tests::outside_references());
}

static void check_whole_penalty_path(const std::vector<tests::Reference>& references) {
  for (const auto& [key, json, problem, rest] : references) {
    const std::string& name = key;
    CAPTURE(name);
    Options options;
    options.method = Method::penalty;
    options.gap_tolerance = 1e-15;  // never: the path runs to its end
    options.penalty.lower_epsilon = false;
    Vector x;
    const Summary summary = sdp_penalty::solve(problem, x, options);
    report(name, summary);
    CHECK(summary.status == Status::path_end);
    const double optimum = json["sdp_eps"]["E_upper"];
    CHECK(summary.energy == doctest::Approx(optimum).epsilon(1e-6));
    CHECK(summary.min_eigenvalue >= 0);
    CHECK(summary.inverted == 0);
  }
}

TEST_CASE("reference optima: the whole penalty path reaches the optimum of epsilon to 1e-6") {
  check_whole_penalty_path(tests::references());
}

TEST_CASE("outside optima: the whole penalty path reaches the optimum of epsilon to 1e-6" *
          tests::outside_data({"sdp"})) {
  check_whole_penalty_path(tests::outside_references());
}

static void check_augmented_lagrangians(const std::vector<tests::Reference>& references) {
  for (const Method method : {Method::augmented_lagrangian, Method::spectral_sdp, Method::pennon})
    for (const auto& [key, json, problem, rest] : references) {
      const std::string& name = key;
      CAPTURE(name);
      CAPTURE(sdp_penalty::method_name(method));
      Options options;
      options.method = method;
      options.gap_tolerance = 1e-6;
      Vector x;
      const Summary summary = sdp_penalty::solve(problem, x, options);
      report(name + " " + std::string(sdp_penalty::method_name(method)), summary);
      CHECK(summary.status == Status::optimal);
      const double lower = json["sdp"]["E_lower"], upper = json["sdp"]["E_upper"];
      CHECK(summary.energy >= lower * (1 - 1e-9));
      CHECK(summary.energy <= upper * (1 + 1e-6));
      CHECK(summary.inverted == 0);
    }
}

TEST_CASE("reference optima: the augmented Lagrangians") {
  check_augmented_lagrangians(tests::references());
}

TEST_CASE("outside optima: the augmented Lagrangians" * tests::outside_data({"sdp"})) {
  check_augmented_lagrangians(tests::outside_references());
}

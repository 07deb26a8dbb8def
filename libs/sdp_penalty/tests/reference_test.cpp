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

TEST_CASE("reference optima: interior point, both margins") {
  const auto references = tests::references();
  CHECK(references.size() >= 3);
  if (references.size() < 10)
    MESSAGE("seven reference instances are skipped: they are not beside the sources");
  for (const auto& [name, json, reference, rest] : references) {
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

TEST_CASE("reference optima: the penalty path, certified, whichever the penalty") {
  for (const auto& [name, json, problem, rest] : tests::references())
    for (const Penalty penalty : sdp_penalty::all_penalties()) {
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

TEST_CASE("reference optima: the whole penalty path reaches the optimum of epsilon to 1e-6") {
  for (const auto& [name, json, problem, rest] : tests::references()) {
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

TEST_CASE("reference optima: the augmented Lagrangians") {
  const auto references = tests::references();
  for (const Method method : {Method::augmented_lagrangian, Method::spectral_sdp, Method::pennon})
    for (const auto& [name, json, problem, rest] : references) {
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

// How many linear solves every method takes, against one property of the problem: the figures 3, 6 and 7 of
// Liu et al. (2016) with what they do not show. CSV on stdout.
//
//   isostretch_sdp_iterations resolution|multiplier|difficulty gap
#include "../tests/swirl.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/sdp_penalty/solver.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace isostretch;
using sdp_penalty::Method;
using sdp_penalty::Options;
using sdp_penalty::Penalty;

struct Variant {
  std::string name;
  Options options;
};

// With the multiplier mu of the penalty factor, and from which factor on; 0: the defaults.
Variant penalty(Penalty kind, double factor, double first) {
  Variant variant{std::string(sdp_penalty::penalty_name(kind)) + " penalty", {}};
  variant.options.method = Method::penalty;
  variant.options.penalty.penalty = kind;
  variant.options.penalty.factor = factor;
  variant.options.penalty.first = first;
  return variant;
}

Variant published(double factor) {
  Variant variant = penalty(Penalty::quadratic, factor, 1);
  variant.name = "as published";
  variant.options.penalty.as_published = true;
  variant.options.penalty.last = 1e15;
  variant.options.penalty.level_iterations = 100;
  return variant;
}

std::vector<Variant> all_variants() {
  std::vector<Variant> variants{{"interior point", {}}, {"augmented Lagrangian", {}}};
  variants[1].options.method = Method::augmented_lagrangian;
  for (const Penalty kind : sdp_penalty::all_penalties()) variants.push_back(penalty(kind, 0, 0));
  variants.push_back(published(10));
  return variants;
}

void run(const char* scene, double x, const sdp_penalty::Problem& problem,
         const std::vector<Variant>& variants, double gap) {
  for (Variant variant : variants) {
    variant.options.gap_tolerance = gap;
    Vector positions;
    const auto s = sdp_penalty::solve(problem, positions, variant.options);
    std::printf("%s,%g,%s,%d,%s,%d,%.2e,%.3f\n", scene, x, variant.name.c_str(), s.linear_solves,
                std::string(sdp_penalty::status_name(s.status)).c_str(), s.inverted, s.gap, s.seconds);
    std::fflush(stdout);
  }
}

void against_resolution(double gap) {
  for (const int n : {10, 20, 40, 80, 160})
    run("square 120", 2.0 * n * n, tests::swirl(n, 120), all_variants(), gap);
  for (const int n : {4, 6, 9, 13})
    run("cube 120", 6.0 * n * n * n, tests::swirl_in_space(n, 120), all_variants(), gap);
}

void against_multiplier(double gap) {
  for (const double factor : {2.0, 5.0, 10.0, 30.0, 100.0, 500.0, 1000.0, 1e4}) {
    std::vector<Variant> variants;
    for (const Penalty kind : sdp_penalty::all_penalties()) variants.push_back(penalty(kind, factor, 1));
    variants.push_back(published(factor));
    run("square 150", factor, tests::swirl(20, 150), variants, gap);
    run("cube 120", factor, tests::swirl_in_space(6, 120), variants, gap);
  }
}

void against_difficulty(double gap) {
  for (const double degrees : {45.0, 90.0, 120.0, 150.0, 180.0, 210.0, 240.0, 270.0}) {
    run("square", degrees, tests::swirl(20, degrees), all_variants(), gap);
    run("cube", degrees, tests::swirl_in_space(6, degrees), all_variants(), gap);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw Error("arguments: resolution|multiplier|difficulty gap");
    const std::string what = argv[1];
    const double gap = std::stod(argv[2]);
    std::printf("scene,x,method,linear_solves,status,inverted,gap,seconds\n");
    if (what == "resolution")
      against_resolution(gap);
    else if (what == "multiplier")
      against_multiplier(gap);
    else if (what == "difficulty")
      against_difficulty(gap);
    else
      throw Error("not resolution, multiplier or difficulty: " + what);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

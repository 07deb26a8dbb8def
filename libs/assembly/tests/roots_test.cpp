#include <isostretch/assembly/roots.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace isostretch::assembly;

namespace {

// c (t - r1)(t - r2)(t - r3) in ascending coefficients, in long double so that the roots survive.
struct Cubic {
  double c0, c1, c2, c3;
};

Cubic from_roots(long double c, long double r1, long double r2, long double r3) {
  return {static_cast<double>(-c * r1 * r2 * r3), static_cast<double>(c * (r1 * r2 + r2 * r3 + r3 * r1)),
          static_cast<double>(-c * (r1 + r2 + r3)), static_cast<double>(c)};
}

double smallest_positive(std::vector<double> roots) {
  double best = std::numeric_limits<double>::infinity();
  for (const double root : roots)
    if (root > 0) best = std::min(best, root);
  return best;
}

}  // namespace

TEST_CASE("quadratic: roots of either sign, double roots, none") {
  CHECK(smallest_positive_root_quadratic(2, -3, 1) == doctest::Approx(1));  // (t - 1)(t - 2)
  CHECK(smallest_positive_root_quadratic(2, 1, -1) == doctest::Approx(2));  // -(t + 1)(t - 2)
  CHECK(smallest_positive_root_quadratic(1, -2, 1) == doctest::Approx(1));  // (t - 1)^2
  CHECK(smallest_positive_root_quadratic(1, -1, 0) == doctest::Approx(1));
  CHECK(std::isinf(smallest_positive_root_quadratic(1, 1, 1)));
  CHECK(std::isinf(smallest_positive_root_quadratic(1, 0, 0)));
  CHECK(std::isinf(smallest_positive_root_quadratic(1, -1, 1)));  // complex
  CHECK(smallest_positive_root_quadratic(0, 1, 1) == 0);          // already on the boundary
}

TEST_CASE("quadratic: tiny leading coefficient and huge scales do not cancel") {
  CHECK(smallest_positive_root_quadratic(1, -1, 1e-18) == doctest::Approx(1).epsilon(1e-15));
  CHECK(smallest_positive_root_quadratic(1, -1, -1e-18) == doctest::Approx(1).epsilon(1e-15));
  CHECK(smallest_positive_root_quadratic(1e-30, -1e-20, 1e-12) ==
        doctest::Approx(1.0000000001e-10).epsilon(1e-1));
  CHECK(smallest_positive_root_quadratic(1e60, -1e70, 1e70) == doctest::Approx(1e-10).epsilon(1e-9));
}

TEST_CASE("cubic: random roots, never beyond the first one by more than its conditioning") {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-3, 3);
  int finite = 0, infinite = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const double r1 = uniform(generator), r2 = uniform(generator), r3 = uniform(generator);
    double c = uniform(generator);
    if (-c * r1 * r2 * r3 < 0) c = -c;  // positive at zero
    const Cubic p = from_roots(c, r1, r2, r3);
    if (!(p.c0 > 1e-6)) continue;
    const double expected = smallest_positive({r1, r2, r3});
    const double found = smallest_positive_root_cubic(p.c0, p.c1, p.c2, p.c3);
    CAPTURE(r1);
    CAPTURE(r2);
    CAPTURE(r3);
    if (std::isinf(expected)) {
      CHECK(std::isinf(found));
      ++infinite;
      continue;
    }
    ++finite;
    // A pair of close roots may be lost to rounding, which moves the answer to the next one: allowed only
    // when the polynomial does not get measurably negative between them.
    if (found > expected * (1 + 1e-6)) {
      double lowest = 0;
      for (int i = 0; i <= 100; ++i) {
        const double t = expected + (std::min(found, expected + 1) - expected) * i / 100;
        lowest = std::min(lowest, p.c0 + t * (p.c1 + t * (p.c2 + t * p.c3)));
      }
      CHECK(lowest > -1e-12 * (std::abs(p.c0) + std::abs(p.c1) + std::abs(p.c2) + std::abs(p.c3)));
    } else {
      CHECK(found >= expected * (1 - 1e-6) - 1e-9);
    }
  }
  CHECK(finite > 4000);
  CHECK(infinite > 400);
}

TEST_CASE("cubic: degenerate degrees agree with the quadratic") {
  CHECK(smallest_positive_root_cubic(2, -3, 1, 0) == doctest::Approx(1));
  CHECK(smallest_positive_root_cubic(1, -0.5, 0, 0) == doctest::Approx(2));
  CHECK(std::isinf(smallest_positive_root_cubic(1, 0, 0, 0)));
  CHECK(std::isinf(smallest_positive_root_cubic(1, 2, 3, 4)));
  CHECK(smallest_positive_root_cubic(1, 0, 0, -1) == doctest::Approx(1));
  CHECK(smallest_positive_root_cubic(-1, 1, 1, 1) == 0);
}

TEST_CASE("cubic: the nearly double root of a sliver is not stepped over") {
  // (t - 1)^2 (5 - t) minus a little: dips below zero just around t = 1.
  const double dip = 1e-10;
  const double found = smallest_positive_root_cubic(5 - dip, -11, 7, -1);
  CHECK(found < 1.0);
  CHECK(found > 0.9999);
}

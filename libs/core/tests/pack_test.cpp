// The pack of the level this test is compiled for; tests/kernels (linalg, energies, ...) run every level.
#include <isostretch/core/pack.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace isostretch;

TEST_CASE("product_difference keeps the digits that plain evaluation loses") {
  const double a = 1.0 + 0x1p-30, b = 1.0 - 0x1p-30;
  CHECK(product_difference(a, b, 1.0, 1.0) == -0x1p-60);  // exact; a*b - 1 evaluates to 0
  CHECK(product_difference(3.0, 5.0, 7.0, 2.0) == 1.0);
}

TEST_CASE("exponent_scale is the power of two below") {
  CHECK(exponent_scale(1.0) == 1.0);
  CHECK(exponent_scale(3.99) == 2.0);
  CHECK(exponent_scale(1e-150) <= 1e-150);
  CHECK(2 * exponent_scale(1e-150) > 1e-150);
  CHECK(exponent_scale(0.0) == 0.0);
}

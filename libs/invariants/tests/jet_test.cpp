#include <isostretch/invariants/partials.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace isostretch;
using namespace isostretch::invariants;

namespace {

using Jet = Jet2<double>;
using Point = std::array<double, 3>;

template <class Function>
Jet at(Function f, const Point& p) {
  return f(Jet(p[0], 1), Jet(p[1], 2), Jet(p[2], 3));
}

std::array<double, 3> gradient(const Jet& j) {
  return {j.d1, j.d2, j.d3};
}

std::array<std::array<double, 3>, 3> hessian(const Jet& j) {
  return {{{j.d11, j.d12, j.d13}, {j.d12, j.d22, j.d23}, {j.d13, j.d23, j.d33}}};
}

// Gradient against differences of values, Hessian against differences of gradients.
template <class Function>
void check(Function f) {
  const Point p = {1.3, 0.7, 1.9};
  const double h = 1e-5;
  const Jet jet = at(f, p);
  for (std::size_t i = 0; i < 3; ++i) {
    Point up = p, down = p;
    up[i] += h;
    down[i] -= h;
    const Jet above = at(f, up), below = at(f, down);
    CHECK(gradient(jet)[i] == doctest::Approx((above.v - below.v) / (2 * h)).epsilon(1e-8));
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(hessian(jet)[i][j] ==
            doctest::Approx((gradient(above)[j] - gradient(below)[j]) / (2 * h)).epsilon(1e-7));
  }
}

// A polynomial and every function in one, for comparing scalars.
template <class T>
T everything(T x, T y, T z) {
  using isostretch::log;
  return x * log(y * z) + sqrt(x + z) / y - cbrt(x * y) * exp(z - x) + pow(x, -1.5) + log1p(y) * expm1(z) +
         abs(x - z) + min(x, y) * max(y, z) + square(x - 2.0 * z);
}

}  // namespace

TEST_CASE("arithmetic of jets") {
  check([](Jet x, Jet y, Jet z) { return x + y * z - x * x * z; });
  check([](Jet x, Jet y, Jet z) { return x / y - z / (x * y); });
  check([](Jet x, Jet y, Jet z) { return -x * y + reciprocal(z); });
  check([](Jet x, Jet y, Jet z) { return fma(x, y - z, z * x); });
  check([](Jet x, Jet y, Jet z) { return 2.0 * x + y * 3.0 - z / 4.0 + 5.0 / z; });
  check([](Jet x, Jet y, Jet z) { return (1.0 + x) * (y - 2.0) * (3.0 - z) * (z + 4.0); });
}

TEST_CASE("functions of jets") {
  check([](Jet x, Jet y, Jet z) { return square(x * y + z); });
  check([](Jet x, Jet y, Jet z) { return sqrt(x * y + z); });
  check([](Jet x, Jet y, Jet z) { return cbrt(x * y * z); });
  check([](Jet x, Jet y, Jet z) { return log(x * y + z) + log1p(x * z); });
  check([](Jet x, Jet y, Jet z) { return exp(x - y * z) + expm1(y - z); });
  check([](Jet x, Jet y, Jet z) { return expm1(y - 9.0 * z) * x; });
  check([](Jet x, Jet y, Jet z) { return pow(x * z + y, -2.0 / 3.0); });
  check([](Jet x, Jet y, Jet z) { return pow(x * z + y, -1.0); });
  check([](Jet x, Jet y, Jet z) { return pow(x * z + y, -0.7); });
  CHECK(std::isnan(pow(Jet(-1.0, 1), -2.0 / 3.0).v));
  check([](Jet x, Jet y, Jet z) { return abs(y * y - x * z) * abs(x + y); });
}

TEST_CASE("branches of jets take the derivatives of the side taken") {
  check([](Jet x, Jet y, Jet z) { return min(x * x, y * z) + max(x * z, y * y); });
  check([](Jet x, Jet y, Jet z) { return select(x < y, x * y, z * z * x); });
  check([](Jet x, Jet y, Jet z) { return select(x > 1.0, x * y * z, z) + select(x < 1.0, x, y * y); });
}

TEST_CASE("all functions mixed") {
  check([](Jet x, Jet y, Jet z) { return everything(x, y, z); });
}

TEST_CASE("constants have no derivatives") {
  const Jet c(3.0);
  CHECK(c.v == 3.0);
  for (const double d : {c.d1, c.d2, c.d3, c.d11, c.d22, c.d33, c.d12, c.d23, c.d13}) CHECK(d == 0.0);
}

TEST_CASE("lanes of a jet are independent and equal to the jet of that lane alone") {
  double in[3][lanes], out[lanes], d12[lanes];
  for (int i = 0; i < lanes; ++i)
    in[0][i] = 1.0 + 0.1 * i, in[1][i] = 0.5 + 0.2 * i, in[2][i] = 2.0 - 0.1 * i;
  const auto jet = everything(Jet2<Pack>(load<Pack>(in[0]), 1), Jet2<Pack>(load<Pack>(in[1]), 2),
                              Jet2<Pack>(load<Pack>(in[2]), 3));
  store(out, jet.v);
  store(d12, jet.d12);
  for (int i = 0; i < lanes; ++i) {
    const Jet alone = everything(Jet(in[0][i], 1), Jet(in[1][i], 2), Jet(in[2][i], 3));
    CHECK(out[i] == doctest::Approx(alone.v).epsilon(1e-14));
    CHECK(d12[i] == doctest::Approx(alone.d12).epsilon(1e-13));
  }
}

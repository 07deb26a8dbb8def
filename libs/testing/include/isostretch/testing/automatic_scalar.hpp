#pragma once

// A scalar that carries its gradient and Hessian in N variables: forward differentiation of second order,
// dense and slow. It shares no code with invariants/jet.hpp on purpose: it is the witness against it.
//
// Real is double, long double, or whatever RealFunctions is specialised for. Energies written for a scalar T
// accept it as they are: log, exp, sqrt, pow, cbrt, ... are found by argument-dependent lookup.

#include <array>
#include <cmath>
#include <type_traits>

namespace isostretch::testing {

/// Where functions of Real come from; specialise for types that <cmath> does not know.
template <class Real>
struct RealFunctions {
  static Real log(Real x) { return std::log(x); }
  static Real log1p(Real x) { return std::log1p(x); }
  static Real exp(Real x) { return std::exp(x); }
  static Real expm1(Real x) { return std::expm1(x); }
  static Real sqrt(Real x) { return std::sqrt(x); }
  static Real cbrt(Real x) { return std::cbrt(x); }
  static Real pow(Real x, Real p) { return std::pow(x, p); }
};

template <class Real, int N>
struct AutomaticScalar {
  Real value;
  std::array<Real, N> gradient{};
  std::array<Real, N * N> hessian{};  ///< symmetric, both triangles

  AutomaticScalar() : value(0) {}
  /// NOLINTNEXTLINE: implicit on purpose, constants mix freely
  template <class Number,
            class = std::enable_if_t<std::is_arithmetic_v<Number> || std::is_same_v<Number, Real>>>
  AutomaticScalar(Number constant) : value(static_cast<Real>(constant)) {}

  static AutomaticScalar variable(Real value, int index) {
    AutomaticScalar x(value);
    x.gradient[index] = Real(1);
    return x;
  }

  /// h(x), with h, h' and h'' at x.value.
  friend AutomaticScalar chain(const AutomaticScalar& x, Real h, Real dh, Real ddh) {
    AutomaticScalar r(h);
    for (int i = 0; i < N; ++i) {
      r.gradient[i] = dh * x.gradient[i];
      for (int j = 0; j < N; ++j)
        r.hessian[i * N + j] = dh * x.hessian[i * N + j] + ddh * x.gradient[i] * x.gradient[j];
    }
    return r;
  }

  friend AutomaticScalar operator+(const AutomaticScalar& x, const AutomaticScalar& y) {
    AutomaticScalar r(x.value + y.value);
    for (int i = 0; i < N; ++i) r.gradient[i] = x.gradient[i] + y.gradient[i];
    for (int i = 0; i < N * N; ++i) r.hessian[i] = x.hessian[i] + y.hessian[i];
    return r;
  }

  friend AutomaticScalar operator*(const AutomaticScalar& x, const AutomaticScalar& y) {
    AutomaticScalar r(x.value * y.value);
    for (int i = 0; i < N; ++i) {
      r.gradient[i] = x.value * y.gradient[i] + x.gradient[i] * y.value;
      for (int j = 0; j < N; ++j)
        r.hessian[i * N + j] = x.value * y.hessian[i * N + j] + y.value * x.hessian[i * N + j] +
                               x.gradient[i] * y.gradient[j] + x.gradient[j] * y.gradient[i];
    }
    return r;
  }

  friend AutomaticScalar operator-(const AutomaticScalar& x) { return chain(x, -x.value, Real(-1), Real(0)); }
  friend AutomaticScalar operator-(const AutomaticScalar& x, const AutomaticScalar& y) { return x + (-y); }
  friend AutomaticScalar operator/(const AutomaticScalar& x, const AutomaticScalar& y) {
    const Real r = Real(1) / y.value;
    return x * chain(y, r, -r * r, Real(2) * r * r * r);
  }

  friend AutomaticScalar sqrt(const AutomaticScalar& x) {
    const Real s = RealFunctions<Real>::sqrt(x.value);
    return chain(x, s, Real(1) / (Real(2) * s), Real(-1) / (Real(4) * s * x.value));
  }
  friend AutomaticScalar cbrt(const AutomaticScalar& x) {
    const Real c = RealFunctions<Real>::cbrt(x.value), dc = c / (Real(3) * x.value);
    return chain(x, c, dc, Real(-2) * dc / (Real(3) * x.value));
  }
  friend AutomaticScalar log(const AutomaticScalar& x) {
    const Real r = Real(1) / x.value;
    return chain(x, RealFunctions<Real>::log(x.value), r, -r * r);
  }
  friend AutomaticScalar log1p(const AutomaticScalar& x) {
    const Real r = Real(1) / (Real(1) + x.value);
    return chain(x, RealFunctions<Real>::log1p(x.value), r, -r * r);
  }
  friend AutomaticScalar exp(const AutomaticScalar& x) {
    const Real e = RealFunctions<Real>::exp(x.value);
    return chain(x, e, e, e);
  }
  friend AutomaticScalar expm1(const AutomaticScalar& x) {
    const Real e = RealFunctions<Real>::exp(x.value);
    return chain(x, RealFunctions<Real>::expm1(x.value), e, e);
  }
  friend AutomaticScalar pow(const AutomaticScalar& x, double exponent) {
    const Real p = static_cast<Real>(exponent), h = RealFunctions<Real>::pow(x.value, p);
    const Real dh = p * h / x.value;
    return chain(x, h, dh, (p - Real(1)) * dh / x.value);
  }
  friend AutomaticScalar abs(const AutomaticScalar& x) { return x.value < Real(0) ? -x : x; }
  friend AutomaticScalar fma(const AutomaticScalar& x, const AutomaticScalar& y, const AutomaticScalar& z) {
    return x * y + z;
  }
  friend AutomaticScalar product_difference(const AutomaticScalar& p, const AutomaticScalar& q,
                                            const AutomaticScalar& r, const AutomaticScalar& s) {
    return p * q - r * s;
  }

  /// Branches compare values; the derivatives are those of the branch taken.
  friend bool operator<(const AutomaticScalar& x, const AutomaticScalar& y) { return x.value < y.value; }
  friend bool operator>(const AutomaticScalar& x, const AutomaticScalar& y) { return x.value > y.value; }
  friend bool operator<=(const AutomaticScalar& x, const AutomaticScalar& y) { return x.value <= y.value; }
  friend bool operator>=(const AutomaticScalar& x, const AutomaticScalar& y) { return x.value >= y.value; }
  friend AutomaticScalar select(bool mask, const AutomaticScalar& x, const AutomaticScalar& y) {
    return mask ? x : y;
  }
  friend AutomaticScalar min(const AutomaticScalar& x, const AutomaticScalar& y) { return x < y ? x : y; }
  friend AutomaticScalar max(const AutomaticScalar& x, const AutomaticScalar& y) { return x > y ? x : y; }
};

}  // namespace isostretch::testing

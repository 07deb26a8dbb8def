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

/// The functions of a real type that AutomaticScalar calls; to be specialised for types that the standard
/// library does not know.
template <class Real>
struct RealFunctions {
  /// Returns the natural logarithm.
  static Real log(Real x) { return std::log(x); }
  /// Returns log(1 + x).
  static Real log1p(Real x) { return std::log1p(x); }
  /// Returns the exponential.
  static Real exp(Real x) { return std::exp(x); }
  /// Returns exp(x) - 1.
  static Real expm1(Real x) { return std::expm1(x); }
  /// Returns the square root.
  static Real sqrt(Real x) { return std::sqrt(x); }
  /// Returns the cube root.
  static Real cbrt(Real x) { return std::cbrt(x); }
  /// Returns x to the power p.
  static Real pow(Real x, Real p) { return std::pow(x, p); }
};

/// A number with its gradient and Hessian in N variables: forward differentiation of second order, dense and
/// slow.
template <class Real, int N>
struct AutomaticScalar {
  Real value;                         ///< The value.
  std::array<Real, N> gradient{};     ///< First derivatives.
  std::array<Real, N * N> hessian{};  ///< Second derivatives, symmetric, both triangles.

  /// Makes the constant 0.
  AutomaticScalar() : value(0) {}
  /// Makes a constant.
  // NOLINTNEXTLINE: implicit on purpose, constants mix freely
  template <class Number,
            class = std::enable_if_t<std::is_arithmetic_v<Number> || std::is_same_v<Number, Real>>>
  AutomaticScalar(Number constant) : value(static_cast<Real>(constant)) {}

  /// Returns an independent variable by its index, 0 to N - 1.
  static AutomaticScalar variable(Real value, int index) {
    AutomaticScalar x(value);
    x.gradient[index] = Real(1);
    return x;
  }

  /// Returns h(x), given h, h' and h'' at x.value.
  friend AutomaticScalar chain(const AutomaticScalar& x, Real h, Real dh, Real ddh) {
    AutomaticScalar r(h);
    for (int i = 0; i < N; ++i) {
      r.gradient[i] = dh * x.gradient[i];
      for (int j = 0; j < N; ++j)
        r.hessian[i * N + j] = dh * x.hessian[i * N + j] + ddh * x.gradient[i] * x.gradient[j];
    }
    return r;
  }

  /// Returns the sum.
  friend AutomaticScalar operator+(const AutomaticScalar& x, const AutomaticScalar& y) {
    AutomaticScalar r(x.value + y.value);
    for (int i = 0; i < N; ++i) r.gradient[i] = x.gradient[i] + y.gradient[i];
    for (int i = 0; i < N * N; ++i) r.hessian[i] = x.hessian[i] + y.hessian[i];
    return r;
  }

  /// Returns the product.
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

  /// Returns the negative.
  friend AutomaticScalar operator-(const AutomaticScalar& x) { return chain(x, -x.value, Real(-1), Real(0)); }
  /// Returns the difference.
  friend AutomaticScalar operator-(const AutomaticScalar& x, const AutomaticScalar& y) { return x + (-y); }
  /// Returns the quotient.
  friend AutomaticScalar operator/(const AutomaticScalar& x, const AutomaticScalar& y) {
    const Real r = Real(1) / y.value;
    return x * chain(y, r, -r * r, Real(2) * r * r * r);
  }

  /// Returns the square root.
  friend AutomaticScalar sqrt(const AutomaticScalar& x) {
    const Real s = RealFunctions<Real>::sqrt(x.value);
    return chain(x, s, Real(1) / (Real(2) * s), Real(-1) / (Real(4) * s * x.value));
  }
  /// Returns the cube root.
  friend AutomaticScalar cbrt(const AutomaticScalar& x) {
    const Real c = RealFunctions<Real>::cbrt(x.value), dc = c / (Real(3) * x.value);
    return chain(x, c, dc, Real(-2) * dc / (Real(3) * x.value));
  }
  /// Returns the natural logarithm.
  friend AutomaticScalar log(const AutomaticScalar& x) {
    const Real r = Real(1) / x.value;
    return chain(x, RealFunctions<Real>::log(x.value), r, -r * r);
  }
  /// Returns log(1 + x).
  friend AutomaticScalar log1p(const AutomaticScalar& x) {
    const Real r = Real(1) / (Real(1) + x.value);
    return chain(x, RealFunctions<Real>::log1p(x.value), r, -r * r);
  }
  /// Returns the exponential.
  friend AutomaticScalar exp(const AutomaticScalar& x) {
    const Real e = RealFunctions<Real>::exp(x.value);
    return chain(x, e, e, e);
  }
  /// Returns exp(x) - 1.
  friend AutomaticScalar expm1(const AutomaticScalar& x) {
    const Real e = RealFunctions<Real>::exp(x.value);
    return chain(x, RealFunctions<Real>::expm1(x.value), e, e);
  }
  /// Returns x to a constant power.
  friend AutomaticScalar pow(const AutomaticScalar& x, double exponent) {
    const Real p = static_cast<Real>(exponent), h = RealFunctions<Real>::pow(x.value, p);
    const Real dh = p * h / x.value;
    return chain(x, h, dh, (p - Real(1)) * dh / x.value);
  }
  /// Returns the absolute value.
  friend AutomaticScalar abs(const AutomaticScalar& x) { return x.value < Real(0) ? -x : x; }
  /// Returns x y + z.
  friend AutomaticScalar fma(const AutomaticScalar& x, const AutomaticScalar& y, const AutomaticScalar& z) {
    return x * y + z;
  }
  /// Returns p q - r s.
  friend AutomaticScalar product_difference(const AutomaticScalar& p, const AutomaticScalar& q,
                                            const AutomaticScalar& r, const AutomaticScalar& s) {
    return p * q - r * s;
  }

  /// Compares the values; the derivatives of what follows are those of the branch taken.
  friend bool operator<(const AutomaticScalar& x, const AutomaticScalar& y) { return x.value < y.value; }
  /// Compares the values; the derivatives of what follows are those of the branch taken.
  friend bool operator>(const AutomaticScalar& x, const AutomaticScalar& y) { return x.value > y.value; }
  /// Compares the values; the derivatives of what follows are those of the branch taken.
  friend bool operator<=(const AutomaticScalar& x, const AutomaticScalar& y) { return x.value <= y.value; }
  /// Compares the values; the derivatives of what follows are those of the branch taken.
  friend bool operator>=(const AutomaticScalar& x, const AutomaticScalar& y) { return x.value >= y.value; }
  /// Returns x where the mask is true, else y.
  friend AutomaticScalar select(bool mask, const AutomaticScalar& x, const AutomaticScalar& y) {
    return mask ? x : y;
  }
  /// Returns the smaller number.
  friend AutomaticScalar min(const AutomaticScalar& x, const AutomaticScalar& y) { return x < y ? x : y; }
  /// Returns the larger number.
  friend AutomaticScalar max(const AutomaticScalar& x, const AutomaticScalar& y) { return x > y ? x : y; }
};

}  // namespace isostretch::testing

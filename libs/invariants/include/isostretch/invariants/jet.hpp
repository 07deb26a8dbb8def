#pragma once

// Second-order forward differentiation in three variables, the invariants I1, I2, I3: value, gradient and
// Hessian of a psi(I1, I2, I3) written once for any scalar. The lanes of a Pack go inside the jet, never the
// other way round.

#include <isostretch/invariants/scalar_functions.hpp>

namespace isostretch::invariants {
inline namespace ISOSTRETCH_ISA {

/// A number with its first and second derivatives with respect to three variables.
template <class T>
struct Jet2 {
  T v;                             ///< The value.
  T d1, d2, d3;                    ///< The first derivatives.
  T d11, d22, d33, d12, d23, d13;  ///< The second derivatives.

  Jet2() = default;
  /// Makes a constant.
  ISOSTRETCH_INLINE Jet2(double constant) : Jet2(T(constant), 0) {}

  /// Makes independent variable 1, 2 or 3, or a constant for variable 0.
  ISOSTRETCH_INLINE Jet2(T value, int variable)
      : v(value),
        d1(variable == 1 ? 1.0 : 0.0),
        d2(variable == 2 ? 1.0 : 0.0),
        d3(variable == 3 ? 1.0 : 0.0),
        d11(0.0),
        d22(0.0),
        d33(0.0),
        d12(0.0),
        d23(0.0),
        d13(0.0) {}
};

/// Returns h(x), given h, h' and h'' at x.v.
template <class T>
ISOSTRETCH_INLINE Jet2<T> chain(const Jet2<T>& x, T h, T dh, T ddh) {
  Jet2<T> r;
  r.v = h;
  r.d1 = dh * x.d1;
  r.d2 = dh * x.d2;
  r.d3 = dh * x.d3;
  r.d11 = fma(ddh * x.d1, x.d1, dh * x.d11);
  r.d22 = fma(ddh * x.d2, x.d2, dh * x.d22);
  r.d33 = fma(ddh * x.d3, x.d3, dh * x.d33);
  r.d12 = fma(ddh * x.d1, x.d2, dh * x.d12);
  r.d23 = fma(ddh * x.d2, x.d3, dh * x.d23);
  r.d13 = fma(ddh * x.d1, x.d3, dh * x.d13);
  return r;
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> operator+(const Jet2<T>& x, const Jet2<T>& y) {
  Jet2<T> r;
  r.v = x.v + y.v;
  r.d1 = x.d1 + y.d1, r.d2 = x.d2 + y.d2, r.d3 = x.d3 + y.d3;
  r.d11 = x.d11 + y.d11, r.d22 = x.d22 + y.d22, r.d33 = x.d33 + y.d33;
  r.d12 = x.d12 + y.d12, r.d23 = x.d23 + y.d23, r.d13 = x.d13 + y.d13;
  return r;
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> operator-(const Jet2<T>& x) {
  Jet2<T> r;
  r.v = -x.v;
  r.d1 = -x.d1, r.d2 = -x.d2, r.d3 = -x.d3;
  r.d11 = -x.d11, r.d22 = -x.d22, r.d33 = -x.d33;
  r.d12 = -x.d12, r.d23 = -x.d23, r.d13 = -x.d13;
  return r;
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> operator-(const Jet2<T>& x, const Jet2<T>& y) {
  return x + (-y);
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> operator*(const Jet2<T>& x, const Jet2<T>& y) {
  Jet2<T> r;
  r.v = x.v * y.v;
  r.d1 = fma(x.v, y.d1, x.d1 * y.v);
  r.d2 = fma(x.v, y.d2, x.d2 * y.v);
  r.d3 = fma(x.v, y.d3, x.d3 * y.v);
  r.d11 = fma(x.v, y.d11, x.d11 * y.v) + T(2.0) * x.d1 * y.d1;
  r.d22 = fma(x.v, y.d22, x.d22 * y.v) + T(2.0) * x.d2 * y.d2;
  r.d33 = fma(x.v, y.d33, x.d33 * y.v) + T(2.0) * x.d3 * y.d3;
  r.d12 = fma(x.v, y.d12, x.d12 * y.v) + fma(x.d1, y.d2, x.d2 * y.d1);
  r.d23 = fma(x.v, y.d23, x.d23 * y.v) + fma(x.d2, y.d3, x.d3 * y.d2);
  r.d13 = fma(x.v, y.d13, x.d13 * y.v) + fma(x.d1, y.d3, x.d3 * y.d1);
  return r;
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> fma(const Jet2<T>& x, const Jet2<T>& y, const Jet2<T>& z) {
  return x * y + z;
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> reciprocal(const Jet2<T>& x) {
  const T i = T(1.0) / x.v;
  const T di = -(i * i);
  return chain(x, i, di, T(-2.0) * i * di);
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> operator/(const Jet2<T>& x, const Jet2<T>& y) {
  return x * reciprocal(y);
}

/// Returns x times a plain number, whose derivatives are not multiplied out.
template <class T>
ISOSTRETCH_INLINE Jet2<T> scaled(const Jet2<T>& x, T s) {
  Jet2<T> r;
  r.v = x.v * s;
  r.d1 = x.d1 * s, r.d2 = x.d2 * s, r.d3 = x.d3 * s;
  r.d11 = x.d11 * s, r.d22 = x.d22 * s, r.d33 = x.d33 * s;
  r.d12 = x.d12 * s, r.d23 = x.d23 * s, r.d13 = x.d13 * s;
  return r;
}

/// Returns x plus a plain number.
template <class T>
ISOSTRETCH_INLINE Jet2<T> shifted(Jet2<T> x, T s) {
  x.v = x.v + s;
  return x;
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> operator*(const Jet2<T>& x, double s) {
  return scaled(x, T(s));
}
template <class T>
ISOSTRETCH_INLINE Jet2<T> operator*(double s, const Jet2<T>& x) {
  return scaled(x, T(s));
}
template <class T>
ISOSTRETCH_INLINE Jet2<T> operator/(const Jet2<T>& x, double s) {
  return scaled(x, T(1.0 / s));
}
template <class T>
ISOSTRETCH_INLINE Jet2<T> operator/(double s, const Jet2<T>& x) {
  return scaled(reciprocal(x), T(s));
}
template <class T>
ISOSTRETCH_INLINE Jet2<T> operator+(const Jet2<T>& x, double s) {
  return shifted(x, T(s));
}
template <class T>
ISOSTRETCH_INLINE Jet2<T> operator+(double s, const Jet2<T>& x) {
  return shifted(x, T(s));
}
template <class T>
ISOSTRETCH_INLINE Jet2<T> operator-(const Jet2<T>& x, double s) {
  return shifted(x, T(-s));
}
template <class T>
ISOSTRETCH_INLINE Jet2<T> operator-(double s, const Jet2<T>& x) {
  return shifted(-x, T(s));
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> square(const Jet2<T>& x) {
  return chain(x, x.v * x.v, T(2.0) * x.v, T(2.0));
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> sqrt(const Jet2<T>& x) {
  const T s = sqrt(x.v);
  const T ds = T(0.5) / s;
  return chain(x, s, ds, T(-0.5) * ds / x.v);
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> cbrt(const Jet2<T>& x) {
  const T c = cbrt(x.v);
  const T dc = c / (T(3.0) * x.v);
  return chain(x, c, dc, T(-2.0 / 3.0) * dc / x.v);
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> log(const Jet2<T>& x) {
  const T i = T(1.0) / x.v;
  return chain(x, log(x.v), i, -(i * i));
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> log1p(const Jet2<T>& x) {
  const T i = T(1.0) / (T(1.0) + x.v);
  return chain(x, log1p(x.v), i, -(i * i));
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> exp(const Jet2<T>& x) {
  const T e = exp(x.v);
  return chain(x, e, e, e);
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> expm1(const Jet2<T>& x) {
  // 1 + expm1 has all digits where it is not small; the other function is only called where it is.
  const T h = expm1(x.v);
  const auto small = h < T(-0.5);
  const T e = any(small) ? select(small, exp(x.v), T(1.0) + h) : T(1.0) + h;
  return chain(x, h, e, e);
}

/// Returns x^p with a constant real exponent, x > 0. The exponents that energies have need no logarithm.
template <class T>
ISOSTRETCH_INLINE Jet2<T> pow(const Jet2<T>& x, double p) {
  if (p == -1) return reciprocal(x);
  if (p == -2.0 / 3) {
    const T i = T(1.0) / x.v, c = cbrt(i), h = select(x.v < T(0.0), T(__builtin_nan("")), c * c);
    const T dh = T(p) * h * i;
    return chain(x, h, dh, T(p - 1.0) * dh * i);
  }
  const T h = pow(x.v, T(p));
  const T dh = T(p) * h / x.v;
  return chain(x, h, dh, T(p - 1.0) * dh / x.v);
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> abs(const Jet2<T>& x) {
  return chain(x, abs(x.v), copysign(T(1.0), x.v), T(0.0));
}

/// Returns the comparison of the values. The derivatives of what follows are those of the branch taken.
template <class T>
ISOSTRETCH_INLINE auto operator<(const Jet2<T>& x, const Jet2<T>& y) {
  return x.v < y.v;
}
template <class T>
ISOSTRETCH_INLINE auto operator<(const Jet2<T>& x, double y) {
  return x.v < T(y);
}
template <class T>
ISOSTRETCH_INLINE auto operator>(const Jet2<T>& x, double y) {
  return T(y) < x.v;
}

template <class Mask, class T>
ISOSTRETCH_INLINE Jet2<T> select(Mask m, const Jet2<T>& x, const Jet2<T>& y) {
  Jet2<T> r;
  r.v = select(m, x.v, y.v);
  r.d1 = select(m, x.d1, y.d1), r.d2 = select(m, x.d2, y.d2), r.d3 = select(m, x.d3, y.d3);
  r.d11 = select(m, x.d11, y.d11), r.d22 = select(m, x.d22, y.d22), r.d33 = select(m, x.d33, y.d33);
  r.d12 = select(m, x.d12, y.d12), r.d23 = select(m, x.d23, y.d23), r.d13 = select(m, x.d13, y.d13);
  return r;
}

template <class T>
ISOSTRETCH_INLINE Jet2<T> min(const Jet2<T>& x, const Jet2<T>& y) {
  return select(x.v < y.v, x, y);
}
template <class T>
ISOSTRETCH_INLINE Jet2<T> max(const Jet2<T>& x, const Jet2<T>& y) {
  return select(y.v < x.v, x, y);
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::invariants

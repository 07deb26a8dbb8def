#pragma once

// The functions that kernels need, on double; pack.hpp has them on a Pack. A mask is a bool here.

#include <isostretch/core/isa_level.hpp>

#include <cmath>
#include <cstring>

namespace isostretch {
inline namespace ISOSTRETCH_ISA {

ISOSTRETCH_INLINE double select(bool mask, double a, double b) {
  return mask ? a : b;
}
ISOSTRETCH_INLINE bool any(bool mask) {
  return mask;
}
ISOSTRETCH_INLINE bool all(bool mask) {
  return mask;
}
ISOSTRETCH_INLINE double sqrt(double a) {
  return __builtin_sqrt(a);
}
ISOSTRETCH_INLINE double abs(double a) {
  return __builtin_fabs(a);
}
ISOSTRETCH_INLINE double min(double a, double b) {
  return a < b ? a : b;
}
ISOSTRETCH_INLINE double max(double a, double b) {
  return a > b ? a : b;
}
ISOSTRETCH_INLINE double copysign(double magnitude, double sign) {
  return __builtin_copysign(magnitude, sign);
}
ISOSTRETCH_INLINE double log(double a) {
  return __builtin_log(a);
}
ISOSTRETCH_INLINE double log1p(double a) {
  return __builtin_log1p(a);
}
ISOSTRETCH_INLINE double exp(double a) {
  return __builtin_exp(a);
}
ISOSTRETCH_INLINE double expm1(double a) {
  return __builtin_expm1(a);
}
ISOSTRETCH_INLINE double cbrt(double a) {
  return __builtin_cbrt(a);
}
ISOSTRETCH_INLINE double pow(double a, double p) {
  return __builtin_pow(a, p);
}
ISOSTRETCH_INLINE double load(const double* p, double) {
  return *p;
}
ISOSTRETCH_INLINE void store(double* p, double a) {
  *p = a;
}

#if defined(__FMA__) || defined(__FP_FAST_FMA)
ISOSTRETCH_INLINE double fma(double a, double b, double c) {
  return __builtin_fma(a, b, c);
}
#define ISOSTRETCH_HAS_FMA 1
#else
#define ISOSTRETCH_HAS_FMA 0
/// Returns a * b + c, not fused, because the processor cannot: a library call per multiplication would cost
/// fifty times as much. product_difference() gives the single rounding where it is needed.
ISOSTRETCH_INLINE double fma(double a, double b, double c) {
  return a * b + c;
}
#endif

/// Returns the power of two in (a/2, a] for normal positive a, and a finite number for zero, subnormal and
/// infinite a.
ISOSTRETCH_INLINE double exponent_scale(double a) {
  unsigned long long bits;
  std::memcpy(&bits, &a, sizeof bits);
  bits &= 0x7ff0000000000000ull;
  std::memcpy(&a, &bits, sizeof a);
  return a;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch

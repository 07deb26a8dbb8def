#pragma once

// One SIMD register of doubles, `Pack`, as wide as the instruction set this file is compiled for, and the
// handful of functions that kernels need on `double` and `Pack` alike. A kernel is a template over the scalar
// T: T = double is the single-element version, T = Pack the batch version, T = Jet2<Pack> the one that
// differentiates.
//
// Everything here lives in the inline namespace of the instruction set (isa_level.hpp), and kernel headers of
// other libraries open the same namespace.
//
// Native intrinsics rather than xsimd 8.1, which is as fast: docs/benchmarks/simd.md says why.

#include <isostretch/core/scalar.hpp>

#include <cmath>
#include <cstring>

namespace isostretch {
inline namespace ISOSTRETCH_ISA {

/// The number of doubles in a Pack.
inline constexpr int lanes = ISOSTRETCH_LANES;

// ---- Pack ----

#if ISOSTRETCH_LANES > 1

#if ISOSTRETCH_LANES == 8
/// Truth values, one per lane.
struct PackMask {
  __mmask8 m;
};
using PackRegister = __m512d;
#elif ISOSTRETCH_LANES == 4
/// Truth values, one per lane, as all bits of a lane or none.
struct PackMask {
  __m256d m;
};
using PackRegister = __m256d;
#else
/// Truth values, one per lane, as all bits of a lane or none.
struct PackMask {
  __m128d m;
};
using PackRegister = __m128d;
#endif

/// A SIMD register of doubles, with the arithmetic of double in every lane.
struct Pack {
  PackRegister v;

  Pack() = default;
  ISOSTRETCH_INLINE Pack(PackRegister r) : v(r) {}
#if ISOSTRETCH_LANES == 8
  ISOSTRETCH_INLINE Pack(double a) : v(_mm512_set1_pd(a)) {}
#elif ISOSTRETCH_LANES == 4
  ISOSTRETCH_INLINE Pack(double a) : v(_mm256_set1_pd(a)) {}
#else
  ISOSTRETCH_INLINE Pack(double a) : v(_mm_set1_pd(a)) {}
#endif

  friend ISOSTRETCH_INLINE Pack operator+(Pack a, Pack b) {
    return a.v + b.v;
  }
  friend ISOSTRETCH_INLINE Pack operator-(Pack a, Pack b) {
    return a.v - b.v;
  }
  friend ISOSTRETCH_INLINE Pack operator*(Pack a, Pack b) {
    return a.v * b.v;
  }
  friend ISOSTRETCH_INLINE Pack operator/(Pack a, Pack b) {
    return a.v / b.v;
  }
  friend ISOSTRETCH_INLINE Pack operator-(Pack a) {
    return -a.v;
  }
  ISOSTRETCH_INLINE Pack& operator+=(Pack b) {
    return *this = *this + b;
  }
  ISOSTRETCH_INLINE Pack& operator-=(Pack b) {
    return *this = *this - b;
  }
  ISOSTRETCH_INLINE Pack& operator*=(Pack b) {
    return *this = *this * b;
  }
};

#if ISOSTRETCH_LANES == 8

ISOSTRETCH_INLINE PackMask operator<(Pack a, Pack b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)};
}
ISOSTRETCH_INLINE PackMask operator<=(Pack a, Pack b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)};
}
ISOSTRETCH_INLINE PackMask operator==(Pack a, Pack b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)};
}
ISOSTRETCH_INLINE PackMask operator&(PackMask a, PackMask b) {
  return {static_cast<__mmask8>(a.m & b.m)};
}
ISOSTRETCH_INLINE PackMask operator|(PackMask a, PackMask b) {
  return {static_cast<__mmask8>(a.m | b.m)};
}
ISOSTRETCH_INLINE PackMask operator!(PackMask a) {
  return {static_cast<__mmask8>(~a.m)};
}
ISOSTRETCH_INLINE bool any(PackMask a) {
  return a.m != 0;
}
ISOSTRETCH_INLINE bool all(PackMask a) {
  return a.m == 0xff;
}
ISOSTRETCH_INLINE Pack select(PackMask m, Pack a, Pack b) {
  return _mm512_mask_blend_pd(m.m, b.v, a.v);
}
ISOSTRETCH_INLINE Pack sqrt(Pack a) {
  return _mm512_sqrt_pd(a.v);
}
ISOSTRETCH_INLINE Pack min(Pack a, Pack b) {
  return _mm512_min_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack max(Pack a, Pack b) {
  return _mm512_max_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack fma(Pack a, Pack b, Pack c) {
  return _mm512_fmadd_pd(a.v, b.v, c.v);
}
ISOSTRETCH_INLINE Pack abs(Pack a) {
  return _mm512_abs_pd(a.v);
}
ISOSTRETCH_INLINE Pack load(const double* p, Pack) {
  return _mm512_loadu_pd(p);
}
ISOSTRETCH_INLINE void store(double* p, Pack a) {
  _mm512_storeu_pd(p, a.v);
}
ISOSTRETCH_INLINE Pack bit_and(Pack a, Pack b) {
  return _mm512_and_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack bit_or(Pack a, Pack b) {
  return _mm512_or_pd(a.v, b.v);
}
#define ISOSTRETCH_MVEC(name) _ZGVeN8v_##name
#define ISOSTRETCH_MVEC2(name) _ZGVeN8vv_##name

#elif ISOSTRETCH_LANES == 4

ISOSTRETCH_INLINE PackMask operator<(Pack a, Pack b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)};
}
ISOSTRETCH_INLINE PackMask operator<=(Pack a, Pack b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)};
}
ISOSTRETCH_INLINE PackMask operator==(Pack a, Pack b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)};
}
ISOSTRETCH_INLINE PackMask operator&(PackMask a, PackMask b) {
  return {_mm256_and_pd(a.m, b.m)};
}
ISOSTRETCH_INLINE PackMask operator|(PackMask a, PackMask b) {
  return {_mm256_or_pd(a.m, b.m)};
}
ISOSTRETCH_INLINE PackMask operator!(PackMask a) {
  return {_mm256_xor_pd(a.m, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))};
}
ISOSTRETCH_INLINE bool any(PackMask a) {
  return _mm256_movemask_pd(a.m) != 0;
}
ISOSTRETCH_INLINE bool all(PackMask a) {
  return _mm256_movemask_pd(a.m) == 0xf;
}
ISOSTRETCH_INLINE Pack select(PackMask m, Pack a, Pack b) {
  return _mm256_blendv_pd(b.v, a.v, m.m);
}
ISOSTRETCH_INLINE Pack sqrt(Pack a) {
  return _mm256_sqrt_pd(a.v);
}
ISOSTRETCH_INLINE Pack min(Pack a, Pack b) {
  return _mm256_min_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack max(Pack a, Pack b) {
  return _mm256_max_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack fma(Pack a, Pack b, Pack c) {
  return _mm256_fmadd_pd(a.v, b.v, c.v);
}
ISOSTRETCH_INLINE Pack abs(Pack a) {
  return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v);
}
ISOSTRETCH_INLINE Pack load(const double* p, Pack) {
  return _mm256_loadu_pd(p);
}
ISOSTRETCH_INLINE void store(double* p, Pack a) {
  _mm256_storeu_pd(p, a.v);
}
ISOSTRETCH_INLINE Pack bit_and(Pack a, Pack b) {
  return _mm256_and_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack bit_or(Pack a, Pack b) {
  return _mm256_or_pd(a.v, b.v);
}
#define ISOSTRETCH_MVEC(name) _ZGVdN4v_##name
#define ISOSTRETCH_MVEC2(name) _ZGVdN4vv_##name

#else

ISOSTRETCH_INLINE PackMask operator<(Pack a, Pack b) {
  return {_mm_cmplt_pd(a.v, b.v)};
}
ISOSTRETCH_INLINE PackMask operator<=(Pack a, Pack b) {
  return {_mm_cmple_pd(a.v, b.v)};
}
ISOSTRETCH_INLINE PackMask operator==(Pack a, Pack b) {
  return {_mm_cmpeq_pd(a.v, b.v)};
}
ISOSTRETCH_INLINE PackMask operator&(PackMask a, PackMask b) {
  return {_mm_and_pd(a.m, b.m)};
}
ISOSTRETCH_INLINE PackMask operator|(PackMask a, PackMask b) {
  return {_mm_or_pd(a.m, b.m)};
}
ISOSTRETCH_INLINE PackMask operator!(PackMask a) {
  return {_mm_xor_pd(a.m, _mm_castsi128_pd(_mm_set1_epi64x(-1)))};
}
ISOSTRETCH_INLINE bool any(PackMask a) {
  return _mm_movemask_pd(a.m) != 0;
}
ISOSTRETCH_INLINE bool all(PackMask a) {
  return _mm_movemask_pd(a.m) == 0x3;
}
ISOSTRETCH_INLINE Pack select(PackMask m, Pack a, Pack b) {
  return _mm_blendv_pd(b.v, a.v, m.m);
}
ISOSTRETCH_INLINE Pack sqrt(Pack a) {
  return _mm_sqrt_pd(a.v);
}
ISOSTRETCH_INLINE Pack min(Pack a, Pack b) {
  return _mm_min_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack max(Pack a, Pack b) {
  return _mm_max_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack fma(Pack a, Pack b, Pack c) {
  return a * b + c;
}
ISOSTRETCH_INLINE Pack abs(Pack a) {
  return _mm_andnot_pd(_mm_set1_pd(-0.0), a.v);
}
ISOSTRETCH_INLINE Pack load(const double* p, Pack) {
  return _mm_loadu_pd(p);
}
ISOSTRETCH_INLINE void store(double* p, Pack a) {
  _mm_storeu_pd(p, a.v);
}
ISOSTRETCH_INLINE Pack bit_and(Pack a, Pack b) {
  return _mm_and_pd(a.v, b.v);
}
ISOSTRETCH_INLINE Pack bit_or(Pack a, Pack b) {
  return _mm_or_pd(a.v, b.v);
}
#define ISOSTRETCH_MVEC(name) _ZGVbN2v_##name
#define ISOSTRETCH_MVEC2(name) _ZGVbN2vv_##name

#endif

ISOSTRETCH_INLINE PackMask operator>(Pack a, Pack b) {
  return b < a;
}
ISOSTRETCH_INLINE PackMask operator>=(Pack a, Pack b) {
  return b <= a;
}
ISOSTRETCH_INLINE Pack copysign(Pack magnitude, Pack sign) {
  return bit_or(abs(magnitude), bit_and(sign, Pack(-0.0)));
}
ISOSTRETCH_INLINE Pack exponent_scale(Pack a) {
  return bit_and(a, Pack(__builtin_inf()));
}

#if defined(ISOSTRETCH_HAVE_LIBMVEC)
extern "C" {
PackRegister ISOSTRETCH_MVEC(log)(PackRegister);
PackRegister ISOSTRETCH_MVEC(log1p)(PackRegister);
PackRegister ISOSTRETCH_MVEC(exp)(PackRegister);
PackRegister ISOSTRETCH_MVEC(expm1)(PackRegister);
PackRegister ISOSTRETCH_MVEC(cbrt)(PackRegister);
PackRegister ISOSTRETCH_MVEC2(pow)(PackRegister, PackRegister);
}
ISOSTRETCH_INLINE Pack log(Pack a) {
  return ISOSTRETCH_MVEC(log)(a.v);
}
ISOSTRETCH_INLINE Pack log1p(Pack a) {
  return ISOSTRETCH_MVEC(log1p)(a.v);
}
ISOSTRETCH_INLINE Pack exp(Pack a) {
  return ISOSTRETCH_MVEC(exp)(a.v);
}
ISOSTRETCH_INLINE Pack expm1(Pack a) {
  return ISOSTRETCH_MVEC(expm1)(a.v);
}
ISOSTRETCH_INLINE Pack cbrt(Pack a) {
  return ISOSTRETCH_MVEC(cbrt)(a.v);
}
ISOSTRETCH_INLINE Pack pow(Pack a, Pack p) {
  return ISOSTRETCH_MVEC2(pow)(a.v, p.v);
}
#else
template <class Function>
ISOSTRETCH_INLINE Pack lane_by_lane(Pack a, Function function) {
  double buffer[lanes];
  store(buffer, a);
  for (int i = 0; i < lanes; ++i) buffer[i] = function(buffer[i]);
  return load(buffer, Pack());
}
ISOSTRETCH_INLINE Pack log(Pack a) {
  return lane_by_lane(a, [](double x) { return log(x); });
}
ISOSTRETCH_INLINE Pack log1p(Pack a) {
  return lane_by_lane(a, [](double x) { return log1p(x); });
}
ISOSTRETCH_INLINE Pack exp(Pack a) {
  return lane_by_lane(a, [](double x) { return exp(x); });
}
ISOSTRETCH_INLINE Pack expm1(Pack a) {
  return lane_by_lane(a, [](double x) { return expm1(x); });
}
ISOSTRETCH_INLINE Pack cbrt(Pack a) {
  return lane_by_lane(a, [](double x) { return cbrt(x); });
}
ISOSTRETCH_INLINE Pack pow(Pack a, Pack p) {
  double exponent[lanes];
  store(exponent, p);
  int lane = 0;
  return lane_by_lane(a, [&](double x) { return pow(x, exponent[lane++]); });
}
#endif
#undef ISOSTRETCH_MVEC
#undef ISOSTRETCH_MVEC2

#else

using Pack = double;

#endif

// ---- compositions on any T ----

/// The type of comparisons of T: bool, or one truth value per lane.
template <class T>
using Mask = decltype(T(0.0) < T(0.0));

/// Returns the double at p, or as many from p on as T has lanes.
template <class T>
ISOSTRETCH_INLINE T load(const double* p) {
  return load(p, T());
}

/// Returns a * a.
template <class T>
ISOSTRETCH_INLINE T square(T a) {
  return a * a;
}

#if !ISOSTRETCH_HAS_FMA
/// Returns the rounding error of a product: a * b = product + error exactly, for |a|, |b| < 1e300 (Dekker
/// 1971).
template <class T>
ISOSTRETCH_INLINE T product_error(T a, T b, T product) {
  const T splitter(134217729.0);
  const T ca = splitter * a, cb = splitter * b;
  const T ah = ca - (ca - a), bh = cb - (cb - b);
  const T al = a - ah, bl = b - bh;
  return ((ah * bh - product) + ah * bl + al * bh) + al * bl;
}
#endif

/// Returns p*q - r*s to about one rounding of the result, whatever cancels (Kahan).
template <class T>
ISOSTRETCH_INLINE T product_difference(T p, T q, T r, T s) {
#if ISOSTRETCH_HAS_FMA
  const T rs = r * s;
  const T error = fma(-r, s, rs);
  return fma(p, q, -rs) + error;
#else
  const T pq = p * q, rs = r * s;
  return (pq - rs) + (product_error(p, q, pq) - product_error(r, s, rs));
#endif
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch

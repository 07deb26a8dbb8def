#pragma once

// Two packs in one scalar type. An iterative kernel such as the SVD is one long chain of roots and divisions,
// and waits for their latency; two independent chains interleaved fill the gaps and are up to 1.6 times as
// fast.
//
// WidePack is the pair where that pays and the plain Pack elsewhere: gcc 12 spills too much with the sixteen
// registers of AVX2, and scalar code has the whole out-of-order window to itself. Measured in
// docs/benchmarks/simd.md.

#include <isostretch/core/pack.hpp>

namespace isostretch {
inline namespace ISOSTRETCH_ISA {

#if ISOSTRETCH_LANES == 8 || ISOSTRETCH_LANES == 2 || (ISOSTRETCH_LANES == 4 && defined(__clang__))

/// Two packs as one scalar type, with the arithmetic of double in every lane.
struct PackPair {
  Pack a, b;

  PackPair() = default;
  ISOSTRETCH_INLINE PackPair(Pack first, Pack second) : a(first), b(second) {}
  ISOSTRETCH_INLINE PackPair(double value) : a(value), b(value) {}
};

/// The truth values of a PackPair, one per lane.
struct PackPairMask {
  Mask<Pack> a, b;
};

ISOSTRETCH_INLINE PackPair operator+(PackPair x, PackPair y) {
  return {x.a + y.a, x.b + y.b};
}
ISOSTRETCH_INLINE PackPair operator-(PackPair x, PackPair y) {
  return {x.a - y.a, x.b - y.b};
}
ISOSTRETCH_INLINE PackPair operator*(PackPair x, PackPair y) {
  return {x.a * y.a, x.b * y.b};
}
ISOSTRETCH_INLINE PackPair operator/(PackPair x, PackPair y) {
  return {x.a / y.a, x.b / y.b};
}
ISOSTRETCH_INLINE PackPair operator-(PackPair x) {
  return {-x.a, -x.b};
}
ISOSTRETCH_INLINE PackPairMask operator<(PackPair x, PackPair y) {
  return {x.a < y.a, x.b < y.b};
}
ISOSTRETCH_INLINE PackPairMask operator<=(PackPair x, PackPair y) {
  return {x.a <= y.a, x.b <= y.b};
}
ISOSTRETCH_INLINE PackPairMask operator>(PackPair x, PackPair y) {
  return y < x;
}
ISOSTRETCH_INLINE PackPairMask operator==(PackPair x, PackPair y) {
  return {x.a == y.a, x.b == y.b};
}
ISOSTRETCH_INLINE PackPairMask operator&(PackPairMask x, PackPairMask y) {
  return {x.a & y.a, x.b & y.b};
}
ISOSTRETCH_INLINE PackPairMask operator|(PackPairMask x, PackPairMask y) {
  return {x.a | y.a, x.b | y.b};
}
ISOSTRETCH_INLINE bool any(PackPairMask x) {
  return any(x.a) || any(x.b);
}
ISOSTRETCH_INLINE bool all(PackPairMask x) {
  return all(x.a) && all(x.b);
}
ISOSTRETCH_INLINE PackPair select(PackPairMask m, PackPair x, PackPair y) {
  return {select(m.a, x.a, y.a), select(m.b, x.b, y.b)};
}
ISOSTRETCH_INLINE PackPair sqrt(PackPair x) {
  return {sqrt(x.a), sqrt(x.b)};
}
ISOSTRETCH_INLINE PackPair abs(PackPair x) {
  return {abs(x.a), abs(x.b)};
}
ISOSTRETCH_INLINE PackPair min(PackPair x, PackPair y) {
  return {min(x.a, y.a), min(x.b, y.b)};
}
ISOSTRETCH_INLINE PackPair max(PackPair x, PackPair y) {
  return {max(x.a, y.a), max(x.b, y.b)};
}
ISOSTRETCH_INLINE PackPair fma(PackPair x, PackPair y, PackPair z) {
  return {fma(x.a, y.a, z.a), fma(x.b, y.b, z.b)};
}
ISOSTRETCH_INLINE PackPair copysign(PackPair x, PackPair y) {
  return {copysign(x.a, y.a), copysign(x.b, y.b)};
}
ISOSTRETCH_INLINE PackPair exponent_scale(PackPair x) {
  return {exponent_scale(x.a), exponent_scale(x.b)};
}
ISOSTRETCH_INLINE PackPair load(const double* p, PackPair) {
  return {load<Pack>(p), load<Pack>(p + lanes)};
}
ISOSTRETCH_INLINE void store(double* p, PackPair x) {
  store(p, x.a);
  store(p + lanes, x.b);
}

/// The scalar type of iterative kernels: a PackPair where two independent chains are faster than one, else a
/// Pack.
using WidePack = PackPair;
/// The number of doubles in a WidePack.
inline constexpr int wide_lanes = 2 * lanes;

#else

/// The scalar type of iterative kernels: a PackPair where two independent chains are faster than one, else a
/// Pack.
using WidePack = Pack;
/// The number of doubles in a WidePack.
inline constexpr int wide_lanes = lanes;
#endif

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch

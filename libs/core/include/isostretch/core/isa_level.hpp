#pragma once

// The instruction-set level that a file is compiled for, as names and numbers for the preprocessor. What
// depends on it lives in an inline namespace of that name, so that copies compiled with different flags are
// different functions for the linker:
//
//   namespace isostretch::linalg {
//   inline namespace ISOSTRETCH_ISA { template <class T> ... }
//   }

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define ISOSTRETCH_ISA v4
#define ISOSTRETCH_KERNELS kernels_v4
#define ISOSTRETCH_LANES 8
#elif defined(__AVX2__) && defined(__FMA__)
#define ISOSTRETCH_ISA v3
#define ISOSTRETCH_KERNELS kernels_v3
#define ISOSTRETCH_LANES 4
#elif defined(__SSE4_2__)
#define ISOSTRETCH_ISA v2
#define ISOSTRETCH_KERNELS kernels_v2
#define ISOSTRETCH_LANES 2
#else
#define ISOSTRETCH_ISA base
#define ISOSTRETCH_KERNELS kernels_base
#define ISOSTRETCH_LANES 1
#endif

#if ISOSTRETCH_LANES > 1
#include <immintrin.h>
#endif

/// Makes a function part of every caller, whatever its size: a missed inline of a jet costs a hundredfold.
#define ISOSTRETCH_INLINE inline __attribute__((always_inline))
/// Makes everything that the function calls part of it, including what a user wrote without
/// ISOSTRETCH_INLINE.
#define ISOSTRETCH_FLATTEN __attribute__((flatten))

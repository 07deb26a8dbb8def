// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "peak_table.hpp"

#include <isostretch/core/isa_level.hpp>
#include <isostretch/core/pack.hpp>

namespace isostretch::sparse::bench {
namespace ISOSTRETCH_KERNELS {
namespace {

// Two units that take four cycles are busy with eight sums at a time; with twelve all stay in 16 registers.
constexpr int sums = 12;

double multiply_add(long rounds) {
  // Read from memory the compiler cannot know, so that it has to compute; sums stay finite.
  const volatile double factor_in_memory = 0.999, addend_in_memory = 1e-3;
  const Pack factor(factor_in_memory), addend(addend_in_memory);
  Pack x[sums];
  for (int i = 0; i < sums; ++i) x[i] = Pack(i + addend_in_memory);
  for (long round = 0; round < rounds; ++round)
    for (int i = 0; i < sums; ++i) x[i] = fma(x[i], factor, addend);
  double result = 0;
  for (int i = 0; i < sums; ++i) {
    alignas(64) double values[lanes];
    store(values, x[i]);
    for (int lane = 0; lane < lanes; ++lane) result += values[lane];
  }
  return result;
}

}  // namespace

extern const PeakTable table;
const PeakTable table = {2.0 * sums * lanes, multiply_add};

}  // namespace ISOSTRETCH_KERNELS
}  // namespace isostretch::sparse::bench

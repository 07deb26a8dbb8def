#pragma once

// The functions of plain numbers and packs, made visible in this namespace: jets add overloads of them here,
// which would otherwise hide the ones for double (a Pack is found by its argument, a double is not). Include
// before declaring any such overload.

#include <isostretch/core/pack.hpp>

namespace isostretch::invariants {
inline namespace ISOSTRETCH_ISA {

using isostretch::abs;
using isostretch::cbrt;
using isostretch::exp;
using isostretch::expm1;
using isostretch::fma;
using isostretch::log;
using isostretch::log1p;
using isostretch::max;
using isostretch::min;
using isostretch::pow;
using isostretch::select;
using isostretch::sqrt;
using isostretch::square;

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::invariants

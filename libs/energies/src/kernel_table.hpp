#pragma once

#include <isostretch/energies/chunk.hpp>

namespace isostretch::energies {

// All built-in energies at one level, in the order of builtin_list.inc.
inline constexpr int builtin_capacity = 64;
struct BuiltinKernels {
  EnergyFunctions functions[builtin_capacity];
};

}  // namespace isostretch::energies

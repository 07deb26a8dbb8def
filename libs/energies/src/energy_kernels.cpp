// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "kernel_table.hpp"

#include <isostretch/energies/evaluate.hpp>

#include "builtin_includes.inc"

namespace isostretch::energies::ISOSTRETCH_KERNELS {

extern const BuiltinKernels builtin_kernels;
const BuiltinKernels builtin_kernels = {{
#define ISOSTRETCH_ENERGY(Struct) detail::functions_of<Struct>(),
#include "builtin_list.inc"
#undef ISOSTRETCH_ENERGY
}};

}  // namespace isostretch::energies::ISOSTRETCH_KERNELS

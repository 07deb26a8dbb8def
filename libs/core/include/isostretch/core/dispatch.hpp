#pragma once

#include <isostretch/core/isa.hpp>

// Choosing between the copies of a kernel file, one per instruction-set level.
//
// A kernel file defines its table, a constant struct of function pointers, in a namespace of its own level:
//   namespace isostretch::linalg::ISOSTRETCH_KERNELS { extern const Table table; const Table table = {...}; }
// and a plain source file says, at namespace scope of isostretch::linalg, one of
//   ISOSTRETCH_KERNEL_LEVELS(Table, table)   // const Table* table_at(Isa), null where the level is not
//   compiled in ISOSTRETCH_DISPATCH(Table, table)        // the same and const Table& active_table(), the
//   copy for active_isa()

#define ISOSTRETCH_DECLARE_KERNELS(level, Table, table) \
  namespace level {                                     \
  extern const Table table;                             \
  }

#if defined(ISOSTRETCH_HAS_ISA_LEVELS)
#define ISOSTRETCH_KERNEL_LEVELS(Table, table)                                                          \
  ISOSTRETCH_DECLARE_KERNELS(kernels_base, Table, table)                                                \
  ISOSTRETCH_DECLARE_KERNELS(kernels_v2, Table, table)                                                  \
  ISOSTRETCH_DECLARE_KERNELS(kernels_v3, Table, table)                                                  \
  ISOSTRETCH_DECLARE_KERNELS(kernels_v4, Table, table)                                                  \
  static const Table* table##_at(::isostretch::Isa isa) {                                               \
    static const Table* const levels[] = {&kernels_base::table, &kernels_v2::table, &kernels_v3::table, \
                                          &kernels_v4::table};                                          \
    return levels[static_cast<int>(isa)];                                                               \
  }
#else
#define ISOSTRETCH_KERNEL_LEVELS(Table, table)                              \
  ISOSTRETCH_DECLARE_KERNELS(kernels_base, Table, table)                    \
  static const Table* table##_at(::isostretch::Isa isa) {                   \
    return isa == ::isostretch::Isa::base ? &kernels_base::table : nullptr; \
  }
#endif

#define ISOSTRETCH_DISPATCH(Table, table)           \
  ISOSTRETCH_KERNEL_LEVELS(Table, table)            \
  static const Table& active_##table() {            \
    return *table##_at(::isostretch::active_isa()); \
  }

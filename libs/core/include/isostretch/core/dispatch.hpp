#pragma once

#include <isostretch/core/isa.hpp>

// Choosing between the copies of a kernel file, one per instruction-set level.
//
// A kernel file defines its table, a constant struct of function pointers, in a namespace of its own level:
//
//   namespace isostretch::linalg::ISOSTRETCH_KERNELS {
//   extern const Table table;
//   const Table table = {...};
//   }
//
// A plain source file says ISOSTRETCH_DISPATCH(Table, table) at namespace scope of isostretch::linalg, or
// ISOSTRETCH_KERNEL_LEVELS(Table, table) if it chooses the level itself.

/// Declares the table of one level, in the namespace of that level.
#define ISOSTRETCH_DECLARE_KERNELS(level, Table, table) \
  namespace level {                                     \
  extern const Table table;                             \
  }

#if defined(ISOSTRETCH_HAS_ISA_LEVELS)
/// Defines `const Table* table_at(Isa)`, which returns the table compiled for a level, or null where there is
/// none.
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
/// Defines `const Table* table_at(Isa)`, which returns the table of the level base, and null for every other
/// level: the build has no more.
#define ISOSTRETCH_KERNEL_LEVELS(Table, table)                              \
  ISOSTRETCH_DECLARE_KERNELS(kernels_base, Table, table)                    \
  static const Table* table##_at(::isostretch::Isa isa) {                   \
    return isa == ::isostretch::Isa::base ? &kernels_base::table : nullptr; \
  }
#endif

/// Defines `const Table* table_at(Isa)`, as ISOSTRETCH_KERNEL_LEVELS does, and `const Table& active_table()`,
/// which returns the table of the level active_isa().
#define ISOSTRETCH_DISPATCH(Table, table)           \
  ISOSTRETCH_KERNEL_LEVELS(Table, table)            \
  static const Table& active_##table() {            \
    return *table##_at(::isostretch::active_isa()); \
  }

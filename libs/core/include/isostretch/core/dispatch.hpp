#pragma once

#include <isostretch/core/isa.hpp>

// Choosing between the copies of a kernel file, one per instruction-set level.
//
// A kernel file defines its table, a constant struct of function pointers, in a namespace of its own level:
//   namespace isostretch::linalg::ISOSTRETCH_KERNELS { extern const Table table; const Table table = {...}; }
// and ISOSTRETCH_DISPATCH(Table, table) at namespace scope of isostretch::linalg, in a plain source file,
// defines `const Table& active_table()`, the copy for active_isa().

#if defined(ISOSTRETCH_HAS_ISA_LEVELS)

#define ISOSTRETCH_DISPATCH(Table, table)                                                               \
  namespace kernels_base {                                                                              \
  extern const Table table;                                                                             \
  }                                                                                                     \
  namespace kernels_v2 {                                                                                \
  extern const Table table;                                                                             \
  }                                                                                                     \
  namespace kernels_v3 {                                                                                \
  extern const Table table;                                                                             \
  }                                                                                                     \
  namespace kernels_v4 {                                                                                \
  extern const Table table;                                                                             \
  }                                                                                                     \
  static const Table& active_##table() {                                                                \
    static const Table* const levels[] = {&kernels_base::table, &kernels_v2::table, &kernels_v3::table, \
                                          &kernels_v4::table};                                          \
    return *levels[static_cast<int>(::isostretch::active_isa())];                                       \
  }

#else

#define ISOSTRETCH_DISPATCH(Table, table) \
  namespace kernels_base {                \
  extern const Table table;               \
  }                                       \
  static const Table& active_##table() {  \
    return kernels_base::table;           \
  }

#endif

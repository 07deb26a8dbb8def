#pragma once

#include <isostretch/sparse/matrix.hpp>

#include <cholmod.h>

namespace isostretch::sparse {

// cholmod_start / cholmod_finish as an object, silent: faults come back in common()->status only.
class CholmodSession {
 public:
  CholmodSession() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
  }
  ~CholmodSession() { cholmod_finish(&common_); }
  CholmodSession(const CholmodSession&) = delete;
  CholmodSession& operator=(const CholmodSession&) = delete;

  cholmod_common* common() { return &common_; }

  // The matrix as CHOLMOD sees it, without a copy. CHOLMOD takes inputs by non-const pointer and only reads
  // them.
  static cholmod_sparse view(const SymmetricMatrix& A) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(A.size);
    view.nzmax = A.row.size();
    view.p = const_cast<int*>(A.column_start.data());
    view.i = const_cast<int*>(A.row.data());
    view.x = const_cast<double*>(A.value.data());
    view.stype = -1;  // lower triangle
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    return view;
  }

  static cholmod_sparse pattern_view(const SymmetricMatrix& A) {
    cholmod_sparse pattern = view(A);
    pattern.x = nullptr;
    pattern.xtype = CHOLMOD_PATTERN;
    return pattern;
  }

 private:
  cholmod_common common_;
};

}  // namespace isostretch::sparse

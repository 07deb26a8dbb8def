#pragma once

#include "front.hpp"

#include <isostretch/cholesky/run.hpp>

#include <cstddef>

namespace isostretch::cholesky {

// The right-hand sides that solves take together, one beside the other.
constexpr int wide = 8;

// Rows that a thread takes at a time. Which vectors and tiles there are depends on it, and not on the
// threads.
constexpr int chunk_rows = 96;

// Dense kernels, one table for every instruction-set level. `panel` columns, as wide as a register tile, are
// factorised together. Where a front is called block, it is a single block of columns.
struct FrontTable {
  int panel;

  // Columns first ... first + count - 1, count <= panel: updates them with those before and factorises what
  // is on the diagonal. `inverse` gets 1 / diagonal. Returns the number of columns before the first pivot
  // that is not a positive number, which `inverse` gets then; count if there is none.
  int (*diagonal)(const Front& block, int first, int count, double* inverse);
  // The same columns, rows begin ... end - 1 below the diagonal: updates them and divides by the diagonal.
  void (*below)(const Front& block, int first, int count, const double* inverse, int begin, int end);
  // C -= A B^T for rows begin ... end - 1 of the lower trapezoid C, whose column j ends at row j; A is of the
  // same rows as C and has k columns, and B is its first `columns` rows. Without `add` C is set.
  void (*update)(const double* a, std::size_t leading, int k, double* c, std::size_t c_leading, int columns,
                 int begin, int end, bool add);

  // Adds columns begin ... end - 1 of an update matrix to `to`, whose first row and column is `first` of the
  // front that the runs speak of. Rows that go on in a run do so there.
  void (*add)(const Front& from, const Run* run, int runs, int begin, int end, const Front& to, int first);

  // t = L^-1 t for the diagonal block, and what is below it is subtracted from the rest of t (rows values).
  void (*forward)(const Front& block, double* t);
  // t of the columns = L^-T (t - rest), the rest of t given.
  void (*backward)(const Front& block, double* t);
  // The same for `wide` right-hand sides: value r of row i at t[wide * i + r].
  void (*forward_wide)(const Front& block, double* t);
  void (*backward_wide)(const Front& block, double* t);
};

}  // namespace isostretch::cholesky

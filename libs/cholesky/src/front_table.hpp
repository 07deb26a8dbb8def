#pragma once

#include <isostretch/cholesky/run.hpp>

#include <cstddef>

namespace isostretch::cholesky {

// A front: the columns of a supernode with `leading` values from one to the next, at least 7 more than rows.
// What a vector reads or writes beyond the last row is padding.
struct Front {
  double* values = nullptr;
  std::size_t leading = 0;
  int rows = 0, columns = 0;
};

// The right-hand sides that solves take together, one beside the other.
constexpr int wide = 8;

// Rows that a thread takes at a time. Which vectors and tiles there are depends on it, and not on the
// threads.
constexpr int chunk_rows = 96;

// Dense kernels, one table for every instruction-set level. `panel` columns, as wide as a register tile, are
// factorised together, and `block` columns before the rest is updated with them.
struct FrontTable {
  int panel;

  // Columns first ... first + count - 1, count <= panel, whose rows have been updated with all columns before
  // `from`: updates and factorises the block on the diagonal. `inverse` gets 1 / diagonal. Returns the number
  // of columns before the first pivot that is not a positive number, which `inverse` gets then; count if
  // there is none.
  int (*diagonal)(const Front& front, int from, int first, int count, double* inverse);
  // The same columns, rows begin ... end - 1 below that block: updates them and divides by the block.
  void (*below)(const Front& front, int from, int first, int count, const double* inverse, int begin,
                int end);
  // C -= A B^T for rows begin ... end - 1 of the lower trapezoid C, whose column j ends at row j; A is of the
  // same rows as C and has k columns, and B is its first `columns` rows. Without `add` C is set.
  void (*update)(const double* a, std::size_t leading, int k, double* c, std::size_t c_leading, int columns,
                 int begin, int end, bool add);

  // Adds columns begin ... end - 1 of the lower trapezoid of an update matrix to `to`, whose first row and
  // column is `first` of the front that the runs speak of. Rows that go on in a run do so there.
  void (*add)(const double* from, std::size_t from_leading, const Run* run, int runs, int begin, int end,
              double* to, std::size_t leading, int first);

  // t = L^-1 t for the diagonal block, and what is below it is subtracted from the rest of t (rows values).
  void (*forward)(const Front& front, double* t);
  // t of the columns = L^-T (t - rest), the rest of t given.
  void (*backward)(const Front& front, double* t);
  // The same for `wide` right-hand sides: value r of row i at t[wide * i + r].
  void (*forward_wide)(const Front& front, double* t);
  void (*backward_wide)(const Front& front, double* t);
};

}  // namespace isostretch::cholesky

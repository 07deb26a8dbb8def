#pragma once

#include <isostretch/core/isa_level.hpp>

#include <cstddef>
#include <cstdint>

namespace isostretch::cholesky {

// The lower trapezoid of a dense matrix: the columns of a supernode, or an update matrix. It is kept in
// blocks of columns that begin at the diagonal, so that little more than the trapezoid is stored. `leading`
// values are from one column of the first block to the next, and fewer by block_columns with every later
// block.
struct Front {
  double* values = nullptr;
  std::size_t leading = 0;
  int rows = 0, columns = 0;
};

// Columns of a block, which are factorised together before the rest is updated with them: what a thread reads
// of them again and again stays in its cache.
constexpr int block_columns = 192;

// Vectors of kernels may go on so far beyond the last value.
constexpr std::int64_t overhang = 16;

// The distance of columns of so many rows. Vectors of kernels, of 8 numbers at most, may begin at any row and
// go on beyond the last.
ISOSTRETCH_INLINE constexpr std::int64_t padded(std::int64_t rows) {
  constexpr std::int64_t widest = 8;
  return (rows + 2 * widest - 2) / widest * widest;
}

// Where row 0 of a column would be, had its block all rows.
ISOSTRETCH_INLINE constexpr std::int64_t column_place(std::int64_t leading, int column) {
  const std::int64_t block = column / block_columns, first = block * block_columns;
  return block_columns * (block * leading - block_columns * (block * (block - 1) / 2)) +
         (column - first) * (leading - first) - first;
}

// Values of a trapezoid, padding included.
ISOSTRETCH_INLINE constexpr std::int64_t trapezoid_values(int rows, int columns) {
  return column_place(padded(rows), columns) + columns / block_columns * block_columns;
}

// The block that begins with column `first`, as a matrix of its own.
ISOSTRETCH_INLINE constexpr Front block_of(const Front& front, int first) {
  const int columns = front.columns - first < block_columns ? front.columns - first : block_columns;
  return {front.values + column_place(static_cast<std::int64_t>(front.leading), first) + first,
          front.leading - static_cast<std::size_t>(first), front.rows - first, columns};
}

}  // namespace isostretch::cholesky

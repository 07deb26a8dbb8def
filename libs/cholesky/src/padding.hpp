#pragma once

#include <cstdint>

namespace isostretch::cholesky {

// The distance of columns of so many rows. Vectors of kernels, of 8 numbers at most, may begin at any row and
// go on beyond the last.
constexpr std::int64_t padded(std::int64_t rows) {
  constexpr std::int64_t widest = 8;
  return (rows + 2 * widest - 2) / widest * widest;
}

}  // namespace isostretch::cholesky

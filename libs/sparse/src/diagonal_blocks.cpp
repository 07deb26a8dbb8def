#include "diagonal_blocks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace isostretch::sparse {

int indefinite_diagonal(const BlockCsr<double>& A) {
  std::array<double, 36> block{};
  for (int i = 0; i < A.rows; ++i) {
    std::copy_n(A.block(A.find(i, i)), A.area(), block.begin());
    if (const int bad = cholesky(block.data(), A.height); bad >= 0) return A.height * i + bad;
  }
  return -1;
}

double largest_diagonal(const BlockCsr<double>& A) {
  double largest = 0;
  for (int i = 0; i < A.rows; ++i) {
    const double* block = A.block(A.find(i, i));
    for (int r = 0; r < A.height; ++r) largest = std::max(largest, std::abs(block[A.height * r + r]));
  }
  return largest;
}

}  // namespace isostretch::sparse

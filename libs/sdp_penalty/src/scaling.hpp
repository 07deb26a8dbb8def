#pragma once

#include <cstddef>
#include <vector>

namespace isostretch::sdp_penalty {

// Nesterov-Todd scaling of pairs of positive definite blocks Z and Y: r with r^-1 Z r^-T = r^T Y r = diag(l).
// Blocks of size x size, row by row; size 2, 3, 4 or 6.
struct Scaling {
  std::vector<double> inverse;  // r^-1
  std::vector<double> weight;   // W = r^-T r^-1, so that W Z W = Y
  std::vector<double> l;        // size entries a block

  // False where a block is not positive definite: rounding, near the boundary.
  bool compute(int size, const std::vector<double>& Z, const std::vector<double>& Y);
};

// Eigenvalues and, unless null, vectors in columns, of symmetric blocks; eigenvalues in no order.
void block_eigen(int size, const std::vector<double>& A, std::vector<double>& lambda, std::vector<double>* Q);

}  // namespace isostretch::sdp_penalty

#pragma once

#include <isostretch/sparse/solver.hpp>

#include <vector>

namespace isostretch::sparse {

// Inverse of the diagonal blocks of A: one block per group, or one per unknown (Jacobi).
class BlockDiagonal {
 public:
  void analyze(const SymmetricMatrix& A, Preconditioner kind);
  // Cholesky factors of the blocks; the first block that has none ends it with its column.
  FactorResult factorize(const SymmetricMatrix& A);
  void apply(const double* r, double* z) const;  // z = M^-1 r

 private:
  int size_of(std::size_t block) const { return first_[block + 1] - first_[block]; }
  void copy_block(const SymmetricMatrix& A, std::size_t block, double* values) const;

  std::vector<int> first_;           // block -> first unknown
  std::vector<std::size_t> offset_;  // block -> its values
  std::vector<double> values_;       // dense lower factors, column by column
};

}  // namespace isostretch::sparse

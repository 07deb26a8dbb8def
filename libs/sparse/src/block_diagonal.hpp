#pragma once

#include "preconditioner.hpp"

#include <vector>

namespace isostretch::sparse {

// Inverse of the diagonal blocks of A: one block per group, or one per unknown (Jacobi).
class BlockDiagonal final : public PreconditionerMethod {
 public:
  explicit BlockDiagonal(Preconditioner kind) : kind_(kind) {}
  FactorResult analyze(const SymmetricMatrix& A, const NodeSystem& system) override;
  // The first block that has no Cholesky factor ends it with its column.
  FactorResult factorize(const NodeSystem& system, const Coordinates& coordinates) override;
  void apply(const double* r, double* z) override;

 private:
  int blocks() const { return static_cast<int>(first_.size()) - 1; }
  int size_of(int block) const { return first_[block + 1] - first_[block]; }
  void copy_block(const BlockCsr<double>& A, int block, double* values) const;

  Preconditioner kind_;
  std::vector<int> first_;           // block -> first slot
  std::vector<std::size_t> offset_;  // block -> its values
  std::vector<double> values_;       // dense lower factors, column by column
};

}  // namespace isostretch::sparse

#pragma once

#include "preconditioner.hpp"

#include <vector>

namespace isostretch::sparse {

// Incomplete Cholesky factorization without fill, IC(0), of the blocks of nodes: (D + W) D^-1 (D + W^T) with
// W strictly lower in the pattern of A. It can break down for positive definite A; then the diagonal blocks
// are enlarged and it begins again (Manteuffel 1980). Couplings between chunks of rows are left out.
class IncompleteCholesky final : public PreconditionerMethod {
 public:
  FactorResult analyze(const SymmetricMatrix& A, const NodeSystem& system) override;
  FactorResult factorize(const NodeSystem& system, const Coordinates& coordinates) override;
  void apply(const double* r, double* z) override;

 private:
  template <int B>
  bool factorize_chunks(const BlockCsr<double>& A);
  template <int B>
  bool factorize_row(const BlockCsr<double>& A, int i, std::vector<int>& mark);
  template <int B>
  void solve_chunk(int chunk);

  std::vector<int> chunk_;
  BlockCsr<double> lower_;       // W
  std::vector<int> source_;      // entry of W -> entry of A
  std::vector<double> inverse_;  // of the blocks of D
  std::vector<std::vector<int>> mark_;
  BlockCsr<float> lower_float_;  // what solutions use: half the memory to read
  std::vector<float> inverse_float_;
  std::vector<float> work_, sums_;
  double scale_ = 1;
  double shift_ = 0;
};

}  // namespace isostretch::sparse

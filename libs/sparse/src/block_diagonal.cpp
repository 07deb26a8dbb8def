#include "block_diagonal.hpp"

#include <algorithm>

namespace isostretch::sparse {

FactorResult BlockDiagonal::analyze(const SymmetricMatrix&, const NodeSystem& system) {
  if (kind_ == Preconditioner::block_jacobi) {
    first_ = system.group_start();
  } else {
    first_.clear();
    for (int slot = 0; slot <= system.size(); ++slot) first_.push_back(slot);
  }
  offset_.assign(1, 0);
  for (int block = 0; block < blocks(); ++block) {
    const auto n = static_cast<std::size_t>(size_of(block));
    offset_.push_back(offset_.back() + n * n);
  }
  values_.resize(offset_.back());
  return {};
}

void BlockDiagonal::copy_block(const BlockCsr<double>& A, int block, double* values) const {
  const int n = size_of(block), first = first_[block], b = A.height;
  std::fill(values, values + n * n, 0.0);
  for (int i = 0; i < n; ++i) {
    const int node = (first + i) / b, within = (first + i) % b;
    for (int k = A.start[node]; k < A.start[node + 1]; ++k)
      for (int c = 0; c < b; ++c) {
        const int j = A.column[k] * b + c - first;
        if (j >= 0 && j < n) values[j * n + i] = A.block(k)[b * within + c];
      }
  }
}

FactorResult BlockDiagonal::factorize(const NodeSystem& system, const Coordinates&) {
  for (int block = 0; block < blocks(); ++block) {
    double* values = values_.data() + offset_[block];
    copy_block(system.matrix(), block, values);
    const int bad = cholesky(values, size_of(block));
    if (bad >= 0) return not_positive_definite(system, first_[block] + bad, " of its diagonal block");
  }
  return {};
}

void BlockDiagonal::apply(const double* r, double* z) {
  constexpr int least = 4096;
  for_ranges(blocks(), least, [&](int begin, int end, int) {
    for (int block = begin; block < end; ++block) {
      const int n = size_of(block), first = first_[block];
      for (int i = 0; i < n; ++i) z[first + i] = r[first + i];
      cholesky_solve(values_.data() + offset_[block], n, z + first);
    }
  });
}

}  // namespace isostretch::sparse

#include "preconditioner.hpp"

#include <cmath>
#include <string>

namespace isostretch::sparse {
namespace {

// In place on the lower triangle of an n x n column-major block; returns the failing column or -1.
int cholesky(double* a, int n) {
  for (int j = 0; j < n; ++j) {
    double* column = a + j * n;
    if (!(column[j] > 0)) return j;
    const double pivot = std::sqrt(column[j]);
    for (int i = j; i < n; ++i) column[i] /= pivot;
    column[j] = pivot;
    for (int k = j + 1; k < n; ++k)
      for (int i = k; i < n; ++i) a[k * n + i] -= column[i] * column[k];
  }
  return -1;
}

void cholesky_solve(const double* a, int n, double* z) {
  for (int j = 0; j < n; ++j) {
    z[j] /= a[j * n + j];
    for (int i = j + 1; i < n; ++i) z[i] -= a[j * n + i] * z[j];
  }
  for (int j = n - 1; j >= 0; --j) {
    for (int i = j + 1; i < n; ++i) z[j] -= a[j * n + i] * z[i];
    z[j] /= a[j * n + j];
  }
}

}  // namespace

void BlockDiagonal::analyze(const SymmetricMatrix& A, Preconditioner kind) {
  const bool by_group = kind == Preconditioner::block_jacobi && !A.group.empty();
  first_.clear();
  for (int j = 0; j < A.size; ++j)
    if (j == 0 || !by_group || A.group[j] != A.group[j - 1]) first_.push_back(j);
  first_.push_back(A.size);
  offset_.assign(1, 0);
  for (std::size_t block = 0; block + 1 < first_.size(); ++block) {
    const auto n = static_cast<std::size_t>(size_of(block));
    offset_.push_back(offset_.back() + n * n);
  }
  values_.resize(offset_.back());
}

void BlockDiagonal::copy_block(const SymmetricMatrix& A, std::size_t block, double* values) const {
  const int n = size_of(block), first = first_[block];
  std::fill(values, values + n * n, 0.0);
  for (int j = 0; j < n; ++j)
    for (int k = A.column_start[first + j]; k < A.column_start[first + j + 1] && A.row[k] < first + n; ++k)
      values[j * n + A.row[k] - first] = A.value[k];
}

FactorResult BlockDiagonal::factorize(const SymmetricMatrix& A) {
  for (std::size_t block = 0; block + 1 < first_.size(); ++block) {
    double* values = values_.data() + offset_[block];
    copy_block(A, block, values);
    const int bad = cholesky(values, size_of(block));
    if (bad < 0) continue;
    const int column = first_[block] + bad;
    return {FactorStatus::not_positive_definite, column,
            "not positive definite: no positive pivot in column " + std::to_string(column) +
                " of its diagonal block"};
  }
  return {};
}

void BlockDiagonal::apply(const double* r, double* z) const {
  for (std::size_t block = 0; block + 1 < first_.size(); ++block) {
    const int n = size_of(block), first = first_[block];
    for (int i = 0; i < n; ++i) z[first + i] = r[first + i];
    cholesky_solve(values_.data() + offset_[block], n, z + first);
  }
}

}  // namespace isostretch::sparse

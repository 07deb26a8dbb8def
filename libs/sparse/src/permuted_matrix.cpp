#include "permuted_matrix.hpp"

#include <algorithm>

namespace isostretch::sparse {
namespace {

// Calls visit(row, column, entry of A) for every entry of P A P^T, folded into the lower triangle.
template <class Visit>
void for_each_permuted(const SymmetricMatrix& A, const std::vector<int>& position, const Visit& visit) {
  for (int j = 0; j < A.size; ++j)
    for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k) {
      const auto [column, row] = std::minmax({position[j], position[A.row[k]]});
      visit(row, column, k);
    }
}

}  // namespace

// Two counting sorts, by row and then by column, leave the rows of every column in order.
PermutedMatrix::PermutedMatrix(const SymmetricMatrix& A, const std::vector<int>& permutation) {
  std::vector<int> position(A.size);
  for (int p = 0; p < A.size; ++p) position[permutation[p]] = p;

  struct Entry {
    int column, source;
  };
  std::vector<int> row_start(A.size + 1, 0), column_start(A.size + 1, 0);
  for_each_permuted(A, position, [&](int row, int column, int) {
    ++row_start[row + 1];
    ++column_start[column + 1];
  });
  for (int i = 0; i < A.size; ++i) {
    row_start[i + 1] += row_start[i];
    column_start[i + 1] += column_start[i];
  }
  std::vector<Entry> by_row(A.row.size());
  std::vector<int> next = row_start;
  for_each_permuted(A, position, [&](int row, int column, int k) { by_row[next[row]++] = {column, k}; });

  matrix_.size = A.size;
  matrix_.row.resize(A.row.size());
  matrix_.value.resize(A.row.size());
  source_.resize(A.row.size());
  next = column_start;
  for (int i = 0; i < A.size; ++i)
    for (int k = row_start[i]; k < row_start[i + 1]; ++k) {
      const int slot = next[by_row[k].column]++;
      matrix_.row[slot] = i;
      source_[slot] = by_row[k].source;
    }
  matrix_.column_start = std::move(column_start);
}

void PermutedMatrix::gather(const SymmetricMatrix& A) {
  for (std::size_t k = 0; k < source_.size(); ++k) matrix_.value[k] = A.value[source_[k]];
}

}  // namespace isostretch::sparse

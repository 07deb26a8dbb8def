#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace isostretch::sparse {

/// A symmetric matrix by its lower triangle in compressed columns: the entries of column j are
/// row[k], value[k] for column_start[j] <= k < column_start[j + 1], rows strictly increasing from the
/// diagonal, which is always present (it may be zero).
struct SymmetricMatrix {
  /// The number of rows and columns.
  int size = 0;
  std::vector<int> column_start;  ///< size + 1
  std::vector<int> row;           ///< nonzeros
  std::vector<double> value;      ///< nonzeros

  /// Node of each unknown (size entries, non-decreasing, gaps allowed), or empty: every unknown its own node.
  /// The fill-reducing ordering works on the nodes, which is faster and keeps the unknowns of a node
  /// together; block-Jacobi takes its blocks from it. Correctness never depends on it.
  std::vector<int> group;

  /// Returns the number of entries stored.
  int nonzeros() const { return static_cast<int>(row.size()); }

  /// Computes y = A x, raw arrays of `size` entries that do not overlap.
  void multiply(const double* x, double* y) const;
  /// Returns A x.
  Eigen::VectorXd multiply(const Eigen::Ref<const Eigen::VectorXd>& x) const {
    Eigen::VectorXd y(size);
    multiply(x.data(), y.data());
    return y;
  }

  /// Throws Error naming the first column (and entry) that breaks the description of the type. Values are not
  /// looked at.
  void validate() const;

  /// Returns whether all values are finite.
  bool is_finite() const;
  /// Throws Error naming row and column of the first value that is NaN or infinite.
  void require_finite() const;
};

/// Returns the lower triangle of a compressed column matrix; entries above the diagonal are ignored. Inline
/// on purpose: the matrix is read with the caller's Eigen.
inline SymmetricMatrix lower_triangle(const Eigen::SparseMatrix<double>& matrix) {
  SymmetricMatrix A;
  A.size = static_cast<int>(matrix.cols());
  A.column_start.push_back(0);
  for (int j = 0; j < A.size; ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
      if (entry.row() < j) continue;
      A.row.push_back(static_cast<int>(entry.row()));
      A.value.push_back(entry.value());
    }
    A.column_start.push_back(A.nonzeros());
  }
  return A;
}

}  // namespace isostretch::sparse

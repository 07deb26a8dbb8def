#pragma once

#include "parallel.hpp"

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace isostretch::sparse {

// A sparse matrix of dense height x width blocks, by rows: those of block row i are column[k] and block(k)
// (row by row) for start[i] <= k < start[i + 1], columns increasing.
template <class T>
struct BlockCsr {
  int rows = 0, columns = 0;  // in blocks
  int height = 1, width = 1;  // of a block
  std::vector<int> start{0};
  std::vector<int> column;
  std::vector<T> value;

  std::size_t area() const { return static_cast<std::size_t>(height) * static_cast<std::size_t>(width); }
  const T* block(int k) const { return value.data() + static_cast<std::size_t>(k) * area(); }
  T* block(int k) { return value.data() + static_cast<std::size_t>(k) * area(); }
  int find(int i, int j) const;  // k of block (i, j), or -1
  void resize_values() { value.resize(column.size() * area()); }
};

template <int n>
using Constant = std::integral_constant<int, n>;

// Calls body(Constant<n>()) for the block sizes there are: inner loops of known length are several times
// faster.
template <class Body>
decltype(auto) with_size(int n, const Body& body) {
  switch (n) {
    case 1:
      return body(Constant<1>());
    case 2:
      return body(Constant<2>());
    case 3:
      return body(Constant<3>());
    default:
      return body(Constant<6>());
  }
}

// y = A x, and y += A x.
template <class T>
void multiply(const BlockCsr<T>& A, const T* x, T* y);
template <class T>
void multiply_add(const BlockCsr<T>& A, const T* x, T* y);

BlockCsr<double> transpose(const BlockCsr<double>& A);
BlockCsr<double> product(const BlockCsr<double>& A, const BlockCsr<double>& B);
// With every value times `factor`.
BlockCsr<float> to_float(const BlockCsr<double>& A, double factor);

// Dense Cholesky factor in place on the lower triangle of an n x n column-major block; returns the column
// without a positive pivot, or -1. And the solution with it, in place.
int cholesky(double* a, int n);
void cholesky_solve(const double* a, int n, double* z);
// In place, of a symmetric positive definite block; returns the column without a positive pivot, or -1.
int invert(double* a, int n);

}  // namespace isostretch::sparse

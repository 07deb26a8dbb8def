#pragma once

#include <isostretch/core/pack.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isostretch::linalg {
inline namespace ISOSTRETCH_ISA {

/// The eigen-decomposition of one symmetric matrix of up to Capacity rows, by Householder's reduction to
/// tridiagonal form and QL steps with Wilkinson's shift (Golub and Van Loan, 8.3). It is meant for sizes at
/// which Jacobi's sweeps over all pairs of rows (symmetric_eigen.hpp) take longer, and for sizes known only
/// at run time.
///
/// Eigen's own solver is not used because it leaves functions in the library whose code depends on the
/// instruction set, of which a program compiled for another may get the wrong copy. Here everything is plain
/// arrays, on which this takes no longer.
template <int Capacity>
class SymmetricEigenQl {
 public:
  /// Decomposes an n x n matrix that is given with all its entries, row i at A + i * n. n is at most
  /// Capacity.
  SymmetricEigenQl(const double* A, int n) : n_(n) {
    converged_ = std::all_of(A, A + n * n, [](double entry) { return std::isfinite(entry); });
    if (!converged_) return;
    copy_scaled(A);
    for (int k = 0; k + 2 < n_; ++k) reduce(k);
    if (n_ > 1) off_[n_ - 2] = a_[n_ - 1][n_ - 2];
    for (int i = 0; i < n_; ++i) value_[i] = a_[i][i];
    accumulate();
    converged_ = iterate();
    for (int i = 0; i < n_; ++i) value_[i] *= scale_;
  }

  /// Returns false if the matrix is not finite, or if an eigenvalue was not found in 30 steps.
  bool converged() const { return converged_; }
  /// Returns eigenvalue i of n, in no particular order.
  double value(int i) const { return value_[i]; }
  /// Returns the unit eigenvector of eigenvalue i, n entries.
  const double* vector(int i) const { return vector_[i].data(); }

 private:
  using Row = std::array<double, Capacity>;
  static constexpr double negligible_square = 1e-290;  ///< Negligible beside 1, and with a finite inverse.

  /// Copies the matrix, scaled to entries of at most 1, such that no square overflows or vanishes.
  void copy_scaled(const double* A) {
    scale_ = 0;
    for (int i = 0; i < n_ * n_; ++i) scale_ = std::max(scale_, std::abs(A[i]));
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) a_[i][j] = scale_ > 0 ? A[i * n_ + j] / scale_ : 0.0;
  }

  /// Replaces A by H A H with H = I - beta v v^T, such that column k ends below its first off-diagonal entry.
  /// v is kept in that column, beta beside it.
  void reduce(int k) {
    const int first = k + 1;
    double below = 0;
    for (int i = first + 1; i < n_; ++i) below += a_[i][k] * a_[i][k];
    const double head = a_[first][k];
    if (below < negligible_square) {
      off_[k] = head;
      beta_[k] = 0;
      return;
    }
    off_[k] = -std::copysign(std::sqrt(head * head + below), head);
    Row v, w;
    for (int i = first; i < n_; ++i) v[i] = a_[i][k];
    v[first] = head - off_[k];
    const double beta = 2 / (v[first] * v[first] + below);
    double along = 0;
    for (int i = first; i < n_; ++i) {
      double sum = 0;
      for (int j = first; j < n_; ++j) sum += a_[i][j] * v[j];
      w[i] = beta * sum;
      along += w[i] * v[i];
    }
    for (int i = first; i < n_; ++i) w[i] -= 0.5 * beta * along * v[i];
    for (int i = first; i < n_; ++i)
      for (int j = first; j < n_; ++j) a_[i][j] -= v[i] * w[j] + w[i] * v[j];
    for (int i = first; i < n_; ++i) a_[i][k] = v[i];
    beta_[k] = beta;
  }

  /// Forms the product of all reflections, with its columns as rows.
  void accumulate() {
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < n_; ++j) vector_[i][j] = 0;
      vector_[i][i] = 1;
    }
    for (int k = n_ - 3; k >= 0; --k) {
      if (beta_[k] == 0) continue;
      Row v;
      for (int j = k + 1; j < n_; ++j) v[j] = a_[j][k];
      for (int i = k + 1; i < n_; ++i) {
        double along = 0;
        for (int j = k + 1; j < n_; ++j) along += vector_[i][j] * v[j];
        along *= beta_[k];
        for (int j = k + 1; j < n_; ++j) vector_[i][j] -= along * v[j];
      }
    }
  }

  bool iterate() {
    for (int begin = 0; begin < n_; ++begin)
      for (int step = 0;; ++step) {
        int end = begin;
        while (end + 1 < n_ && !negligible(end)) ++end;
        if (end == begin) break;
        if (step == 30) return false;
        ql_step(begin, end);
      }
    return true;
  }

  bool negligible(int i) const {
    constexpr double tiny = std::numeric_limits<double>::min(),
                     rounding = std::numeric_limits<double>::epsilon();
    return std::abs(off_[i]) <= std::max(tiny, rounding * (std::abs(value_[i]) + std::abs(value_[i + 1])));
  }

  /// Takes one implicit step on rows begin ... end, from the bottom up, with the shift from the block at the
  /// top.
  void ql_step(int begin, int end) {
    const double half = 0.5 * (value_[begin + 1] - value_[begin]), e = off_[begin];
    const double shift = value_[begin] - e * e / (half + std::copysign(std::hypot(half, e), half));
    double x = value_[end] - shift, z = off_[end - 1];
    for (int i = end - 1; i >= begin; --i) {
      const double length = std::sqrt(x * x + z * z);
      const double c = length > 0 ? x / length : 1.0, s = length > 0 ? z / length : 0.0;
      rotate(i, c, s);
      if (i + 1 < end) off_[i + 1] = length;
      if (i > begin) {
        x = off_[i];
        z = s * off_[i - 1];
        off_[i - 1] *= c;
      }
    }
  }

  /// Applies the plane rotation of rows i and i + 1 that leads (x, z), x of row i + 1, to (length, 0).
  void rotate(int i, double c, double s) {
    const double low = value_[i], high = value_[i + 1], e = off_[i];
    value_[i] = c * c * low - 2 * c * s * e + s * s * high;
    value_[i + 1] = c * c * high + 2 * c * s * e + s * s * low;
    off_[i] = c * s * (low - high) + (c * c - s * s) * e;
    double *v = vector_[i].data(), *w = vector_[i + 1].data();
    for (int j = 0; j < n_; ++j) {
      const double below = w[j];
      w[j] = c * below + s * v[j];
      v[j] = c * v[j] - s * below;
    }
  }

  int n_;
  double scale_;
  bool converged_;
  std::array<Row, Capacity> a_, vector_;
  Row value_, off_, beta_;
};

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::linalg

#pragma once

// Kernel templates: filtering the eigenvalues of the Hessian of an isotropic energy, in the frame of the
// singular vectors where it falls into twists, flips and the dim x dim scaling block A (Smith, de Goes, Kim
// 2019, section 4).

#include <isostretch/invariants/stretch.hpp>
#include <isostretch/linalg/symmetric_eigen.hpp>
#include <isostretch/projection/filter.hpp>

namespace isostretch::projection {
inline namespace ISOSTRETCH_ISA {

/// Returns an eigenvalue after filtering; `bound` is the largest magnitude that bounded_abs may give it.
template <Filter filter, class T>
ISOSTRETCH_INLINE T filtered(T lambda, T bound, double threshold, double weight) {
  if constexpr (filter == Filter::none) return lambda;
  if constexpr (filter == Filter::bounded_abs)
    return max(max(lambda, min(T(-weight) * lambda, bound)), T(threshold));
  const T target = max(filter == Filter::abs ? abs(lambda) : lambda, T(threshold));
  return weight == 1.0 ? target : fma(T(weight), target - lambda, lambda);
}

/// Returns A, the scaling block, as a matrix.
template <int Dim, class T>
ISOSTRETCH_INLINE linalg::Mat<Dim, T> scaling_block(const invariants::StretchDerivatives<Dim, T>& d) {
  linalg::Mat<Dim, T> A;
  for (int i = 0; i < Dim; ++i) A[i][i] = d.diagonal[i];
  for (int i = 0; i < d.pairs; ++i) {
    const int j = invariants::first<Dim>(i), k = invariants::second<Dim>(i);
    A[j][k] = A[k][j] = d.coupling[i];
  }
  return A;
}

/// Returns a number no smaller than the magnitude of any flip and scaling eigenvalue (Gershgorin).
template <int Dim, class T>
ISOSTRETCH_INLINE T largest_magnitude(const invariants::StretchDerivatives<Dim, T>& d) {
  T bound(0.0), row[Dim];
  for (int i = 0; i < Dim; ++i) row[i] = abs(d.diagonal[i]);
  for (int i = 0; i < d.pairs; ++i) {
    bound = max(bound, abs(d.flip[i]));
    row[invariants::first<Dim>(i)] = row[invariants::first<Dim>(i)] + abs(d.coupling[i]);
    row[invariants::second<Dim>(i)] = row[invariants::second<Dim>(i)] + abs(d.coupling[i]);
  }
  for (int i = 0; i < Dim; ++i) bound = max(bound, row[i]);
  return bound;
}

/// Returns a mask of the lanes in which A - threshold I is positive definite beyond doubt (by the pivots of
/// its Cholesky factorization), so that they need no eigen-decomposition.
template <int Dim, class T>
ISOSTRETCH_INLINE Mask<T> surely_positive(const linalg::Mat<Dim, T>& A, double threshold) {
  const T doubt(1e-13), shift(threshold);
  const T a = A[0][0] - shift, b = A[1][1] - shift;
  const T safe_a = select(a > T(0.0), a, T(1.0));
  const T l = A[1][0] / safe_a;
  const T pivot = fma(-l, A[1][0], b);
  Mask<T> positive = (a > doubt * abs(A[0][0])) & (pivot > doubt * abs(A[1][1]));
  if constexpr (Dim == 3) {
    const T safe_pivot = select(pivot > T(0.0), pivot, T(1.0));
    const T m = fma(-l, A[2][0], A[2][1]);
    const T last = A[2][2] - shift - A[2][0] * A[2][0] / safe_a - m * m / safe_pivot;
    positive = positive & (last > doubt * abs(A[2][2]));
  }
  return positive;
}

/// Filters all eigenvalues in place and returns the mask of points at which any changed. What does not change
/// stays as it was, bit for bit. `coupled` says whether A can have off-diagonal entries.
template <Filter filter, int Dim, class T>
ISOSTRETCH_INLINE Mask<T> apply_filter(invariants::StretchDerivatives<Dim, T>& d, double threshold,
                                       double weight, bool coupled) {
  Mask<T> changed = T(0.0) > T(0.0);
  if constexpr (filter == Filter::none) return changed;
  const T floor(threshold);
  T bound(0.0);
  if constexpr (filter == Filter::bounded_abs) bound = largest_magnitude(d);
  for (int i = 0; i < d.pairs; ++i) {
    changed = changed | (d.twist[i] < floor) | (d.flip[i] < floor);
    d.twist[i] = filtered<filter>(d.twist[i], bound, threshold, weight);
    d.flip[i] = filtered<filter>(d.flip[i], bound, threshold, weight);
  }
  if (!coupled) {
    for (int i = 0; i < Dim; ++i) {
      changed = changed | (d.diagonal[i] < floor);
      d.diagonal[i] = filtered<filter>(d.diagonal[i], bound, threshold, weight);
    }
    return changed;
  }
  const linalg::Mat<Dim, T> A = scaling_block(d);
  if (all(surely_positive(A, threshold))) return changed;
  linalg::SymmetricEigen<Dim, T> eigen;
  symmetric_eigen(A, eigen);
  Mask<T> moved = eigen.lambda[0] < floor;
  T lambda[Dim];
  for (int i = 0; i < Dim; ++i) {
    moved = moved | (eigen.lambda[i] < floor);
    lambda[i] = filtered<filter>(eigen.lambda[i], bound, threshold, weight);
  }
  const auto rebuilt = [&](int r, int c) {
    T sum = eigen.Q[r][0] * lambda[0] * eigen.Q[c][0];
    for (int k = 1; k < Dim; ++k) sum = fma(eigen.Q[r][k] * lambda[k], eigen.Q[c][k], sum);
    return sum;
  };
  for (int i = 0; i < Dim; ++i) d.diagonal[i] = select(moved, rebuilt(i, i), d.diagonal[i]);
  for (int i = 0; i < d.pairs; ++i) {
    const int j = invariants::first<Dim>(i), k = invariants::second<Dim>(i);
    d.coupling[i] = select(moved, rebuilt(j, k), d.coupling[i]);
  }
  return changed | moved;
}

/// Filters all eigenvalues in place as the options say and returns the mask of points at which any changed:
/// the choice at run time, outside the arithmetic.
template <int Dim, class T>
ISOSTRETCH_INLINE Mask<T> apply_filter(const FilterOptions& options,
                                       invariants::StretchDerivatives<Dim, T>& d, bool coupled) {
  if (options.filter == Filter::clamp)
    return apply_filter<Filter::clamp>(d, options.threshold, options.weight, coupled);
  if (options.filter == Filter::abs)
    return apply_filter<Filter::abs>(d, options.threshold, options.weight, coupled);
  if (options.filter == Filter::bounded_abs)
    return apply_filter<Filter::bounded_abs>(d, options.threshold, options.weight, coupled);
  return apply_filter<Filter::none>(d, options.threshold, options.weight, coupled);
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::projection

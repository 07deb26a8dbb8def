#pragma once

// Kernel templates: signed singular value decomposition of Dim x Dim matrices, Dim = 2 or 3, for T = double
// (one matrix) or Pack (one matrix a lane). Users want linalg/decompositions.hpp.
//
//   F = U diag(sigma) V^T,  U and V rotations,  sigma_0 >= ... >= |sigma_last|: a reflection sits in the last
//   sigma.
//
// One-sided Jacobi (Hestenes 1958) with de Rijk's pivoting: columns of B = F V are rotated until they are
// orthogonal. Unlike methods that form F^T F or bidiagonalise, it finds small singular values of graded
// matrices to high relative accuracy (Demmel & Veselic 1992). U comes from the columns of B and cross
// products, hence is a rotation to rounding also when F is singular. Entries of magnitude 1e-150 to 1e150,
// and zeros, give finite results.

#include <isostretch/linalg/matrix.hpp>

namespace isostretch::linalg {
inline namespace ISOSTRETCH_ISA {

/// The signed singular value decomposition F = U diag(sigma) V^T, with rotations U and V and sigma_0 >= ...
/// >= |sigma_last|.
template <int Dim, class T>
struct Svd {
  Mat<Dim, T> U;
  T sigma[Dim];
  Mat<Dim, T> V;
};

namespace detail {

/// The cosine between two columns below which they count as orthogonal, just above the rounding of dot
/// products.
inline constexpr double orthogonality = 1e-15;
inline constexpr int max_sweeps = 15;

template <int Dim, class T>
ISOSTRETCH_INLINE T column_dot(const Mat<Dim, T>& B, int p, int q) {
  T sum = B[0][p] * B[0][q];
  for (int i = 1; i < Dim; ++i) sum = fma(B[i][p], B[i][q], sum);
  return sum;
}

template <int Dim, class T>
ISOSTRETCH_INLINE void rotate_columns(Mat<Dim, T>& B, int p, int q, T c, T s) {
  for (int i = 0; i < Dim; ++i) {
    const T bp = B[i][p], bq = B[i][q];
    B[i][p] = fma(c, bp, s * bq);
    B[i][q] = fma(c, bq, -(s * bp));
  }
}

/// Makes columns p < q of B orthogonal with the longer one first, and rotates V along. Returns whether any
/// lane was not yet orthogonal. Lanes that are in order stay as they are bit for bit: a lane's result is
/// independent of its neighbours.
template <int Dim, bool WithV, class T>
ISOSTRETCH_INLINE bool orthogonalize(Mat<Dim, T>& B, Mat<Dim, T>& V, int p, int q) {
  const T a = column_dot(B, p, p), b = column_dot(B, q, q), g = column_dot(B, p, q);
  const auto oblique = square(g) > a * b * T(orthogonality * orthogonality);
  const auto unordered = a < b;
  if (!any(oblique | unordered)) return false;
  // p' = c p + s q, q' = c q - s p with tan(2 theta) = 2 g / (a - b) and |theta| <= 45 degrees.
  const T zero(0.0), one(1.0);
  const T d = a - b;
  const T h = abs(d) + sqrt(fma(d, d, T(4.0) * g * g));
  const T t = select(oblique, copysign(T(2.0), d) * g / select(oblique, h, one), zero);
  const T cosine = one / sqrt(fma(t, t, one));
  const T sine = cosine * t;
  // Where q is the longer one, exchange in the same stroke: (p, q) <- (q', -p').
  const T c = select(unordered, -sine, cosine);
  const T s = select(unordered, cosine, sine);
  rotate_columns(B, p, q, c, s);
  if constexpr (WithV) rotate_columns(V, p, q, c, s);
  // An exchange alone counts too: it brings columns into pairs that this sweep has already passed.
  return true;
}

template <int Dim, bool WithV, class T>
ISOSTRETCH_INLINE void orthogonalize_columns(Mat<Dim, T>& B, Mat<Dim, T>& V) {
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    bool rotated = false;
    for (int p = 0; p < Dim; ++p)
      for (int q = p + 1; q < Dim; ++q) rotated |= orthogonalize<Dim, WithV>(B, V, p, q);
    if (!rotated) return;
  }
}

/// Returns a power of two near the largest entry; 1 for a zero matrix.
template <int Dim, class T>
ISOSTRETCH_INLINE T exact_scale(const Mat<Dim, T>& F) {
  T largest(0.0);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) largest = max(largest, abs(F[i][j]));
  const T scale = exponent_scale(largest);
  return select(scale > T(0.0), scale, T(1.0));
}

template <int Dim, class T>
ISOSTRETCH_INLINE T norm(const T (&a)[Dim]) {
  T sum = a[0] * a[0];
  for (int i = 1; i < Dim; ++i) sum = fma(a[i], a[i], sum);
  return sqrt(sum);
}

/// Divides a by a power of two near its largest entry and returns that power (1 for a = 0): what follows may
/// square the entries of a column as short as 1e-300.
template <int Dim, class T>
ISOSTRETCH_INLINE T extract_scale(T (&a)[Dim]) {
  T largest = abs(a[0]);
  for (int i = 1; i < Dim; ++i) largest = max(largest, abs(a[i]));
  T scale = exponent_scale(largest);
  scale = select(scale > T(0.0), scale, T(1.0));
  const T inverse = T(1.0) / scale;
  for (int i = 0; i < Dim; ++i) a[i] = a[i] * inverse;
  return scale;
}

/// Makes u the first column of U and returns sigma_0; e_0 and 0 for a zero column.
template <int Dim, class T>
ISOSTRETCH_INLINE T normalize_first(T (&u)[Dim]) {
  const T zero(0.0), one(1.0);
  const T length = norm<Dim>(u);
  const auto null = length == zero;
  const T inverse = one / select(null, one, length);
  for (int i = 0; i < Dim; ++i) u[i] = u[i] * inverse;
  u[0] = select(null, one, u[0]);
  return length;
}

template <class T>
ISOSTRETCH_INLINE void cross(const T (&a)[3], const T (&b)[3], T (&c)[3]) {
  c[0] = product_difference(a[1], b[2], a[2], b[1]);
  c[1] = product_difference(a[2], b[0], a[0], b[2]);
  c[2] = product_difference(a[0], b[1], a[1], b[0]);
}

/// Makes `result` a unit vector perpendicular to the unit vector a: e_k x a normalised, k the smallest
/// component of a.
template <class T>
ISOSTRETCH_INLINE void any_perpendicular(const T (&a)[3], T (&result)[3]) {
  const T x = abs(a[0]), y = abs(a[1]), z = abs(a[2]);
  const T zero(0.0), one(1.0);
  const auto use_x = (x <= y) & (x <= z);
  const T ex = select(use_x, one, zero);
  const T ey = select(use_x, zero, select(y <= z, one, zero));
  const T ez = one - ex - ey;
  const T e[3] = {ex, ey, ez};
  cross(e, a, result);
  const T inverse = one / norm<3>(result);
  for (int i = 0; i < 3; ++i) result[i] = result[i] * inverse;
}

/// Computes U and sigma from B = U diag(sigma), whose columns are orthogonal and in descending order; the
/// largest entry of B is about 1.
template <class T>
ISOSTRETCH_INLINE void split_columns(const Mat<3, T>& B, Mat<3, T>& U, T (&sigma)[3]) {
  T u0[3], u1[3], u2[3];
  for (int i = 0; i < 3; ++i) u0[i] = B[i][0], u1[i] = B[i][1];
  sigma[0] = normalize_first<3>(u0);
  // The columns are orthogonal relative to their own lengths, and one more projection makes U orthogonal to
  // rounding; what is not orthogonal then is the noise that a matrix of rank one leaves below the squares'
  // range, hence zero.
  const T scale = extract_scale<3>(u1);
  T along = u0[0] * u1[0];
  for (int i = 1; i < 3; ++i) along = fma(u0[i], u1[i], along);
  for (int i = 0; i < 3; ++i) u1[i] = fma(-along, u0[i], u1[i]);
  const T length = norm<3>(u1);
  const auto null = length < T(1e-6);
  const T one(1.0), zero(0.0);
  const T inverse = one / select(null, one, length);
  for (int i = 0; i < 3; ++i) u1[i] = u1[i] * inverse;
  if (any(null)) {
    T perpendicular[3];
    any_perpendicular(u0, perpendicular);
    for (int i = 0; i < 3; ++i) u1[i] = select(null, perpendicular[i], u1[i]);
  }
  sigma[1] = min(select(null, zero, length * scale), sigma[0]);
  cross(u0, u1, u2);
  const T last = fma(u2[2], B[2][2], fma(u2[1], B[1][2], u2[0] * B[0][2]));
  sigma[2] = copysign(min(abs(last), sigma[1]), last);
  for (int i = 0; i < 3; ++i) U[i][0] = u0[i], U[i][1] = u1[i], U[i][2] = u2[i];
}

template <class T>
ISOSTRETCH_INLINE void split_columns(const Mat<2, T>& B, Mat<2, T>& U, T (&sigma)[2]) {
  T u[2] = {B[0][0], B[1][0]};
  sigma[0] = normalize_first<2>(u);
  const T last = fma(u[0], B[1][1], -(u[1] * B[0][1]));
  sigma[1] = copysign(min(abs(last), sigma[0]), last);
  U[0][0] = u[0], U[1][0] = u[1];
  U[0][1] = -u[1], U[1][1] = u[0];
}

}  // namespace detail

/// Computes the signed singular value decomposition of F by one-sided Jacobi rotations (Hestenes 1958, with
/// de Rijk's pivoting). WithV = false leaves V untouched and unset, for callers that need U and sigma, or
/// sigma alone.
template <int Dim, bool WithV = true, class T>
ISOSTRETCH_INLINE void signed_svd(const Mat<Dim, T>& F, Svd<Dim, T>& result) {
  const T scale = detail::exact_scale(F);
  const T inverse_scale = T(1.0) / scale;
  Mat<Dim, T> B;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) B[i][j] = F[i][j] * inverse_scale;
  const Mat<Dim, T> scaled = B;
  if constexpr (WithV) set_identity(result.V);
  detail::orthogonalize_columns<Dim, WithV>(B, result.V);
  detail::split_columns(B, result.U, result.sigma);
  if constexpr (Dim == 2) {
    // The determinant to full relative accuracy gives the small sigma of nearly parallel columns as well.
    const T det = product_difference(scaled[0][0], scaled[1][1], scaled[0][1], scaled[1][0]);
    const T one(1.0), zero(0.0);
    const auto null = result.sigma[0] == zero;
    const T last = det / select(null, one, result.sigma[0]);
    result.sigma[1] = copysign(min(abs(last), result.sigma[0]), last);
  }
  for (int i = 0; i < Dim; ++i) result.sigma[i] = result.sigma[i] * scale;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::linalg

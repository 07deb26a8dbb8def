#pragma once

// Signed singular value, polar and symmetric eigen-decompositions of 2x2 and 3x3 matrices (and the last also
// of 4x4 and 6x6), one at a time or in batches. Both run the same kernel at the active instruction-set level
// (core/isa.hpp): a single matrix is a batch of one.
//
// Finite input from 1e-150 to 1e150 in magnitude (and zeros) never gives NaN; NaN and infinity in give NaN
// out.

#include <isostretch/core/pack.hpp>
#include <isostretch/linalg/batches.hpp>

#include <Eigen/Core>

namespace isostretch::linalg {

/// Computes the signed singular value decompositions of a batch of dim x dim matrices, F = U diag(sigma) V^T
/// with rotations U and V, at the active instruction-set level. Finite entries of magnitude 1e-150 to 1e150,
/// and zeros, never give NaN; NaN and infinity give NaN. Throws Error unless dim is 2 or 3.
void signed_svd(int dim, const SvdBatch& batch);

/// Computes the polar decompositions F = R S of a batch of dim x dim matrices, at the active instruction-set
/// level. Finite entries of magnitude 1e-150 to 1e150, and zeros, never give NaN. Throws Error unless dim is
/// 2 or 3.
void polar(int dim, const PolarBatch& batch);

/// Computes the eigen-decompositions of a batch of symmetric dim x dim matrices, at the active
/// instruction-set level; takes less time where batch.Q is null. Throws Error unless dim is 2, 3, 4 or 6.
void symmetric_eigen(int dim, const EigenBatch& batch);

// One matrix, with Eigen types. Inline, so that no Eigen type whose alignment depends on compiler flags
// crosses a compiled boundary; in the namespace of the caller's instruction set for the same reason.
inline namespace ISOSTRETCH_ISA {

/// The result of signed_svd() for one matrix: F = U diag(sigma) V^T.
template <int Dim>
struct SignedSvd {
  Eigen::Matrix<double, Dim, Dim> U;    ///< Rotation.
  Eigen::Matrix<double, Dim, 1> sigma;  ///< sigma_0 >= ... >= |sigma_last|, the sign of det F in the last.
  Eigen::Matrix<double, Dim, Dim> V;    ///< Rotation.
};

/// Returns the signed singular value decomposition of one matrix, that of a batch of one.
template <int Dim>
SignedSvd<Dim> signed_svd(const Eigen::Matrix<double, Dim, Dim>& F) {
  SignedSvd<Dim> result;
  signed_svd(Dim, SvdBatch{F.data(), result.U.data(), result.sigma.data(), result.V.data(), 1, 1});
  return result;
}

/// The result of polar() for one matrix: F = R S.
template <int Dim>
struct Polar {
  Eigen::Matrix<double, Dim, Dim> R;  ///< The rotation closest to F.
  Eigen::Matrix<double, Dim, Dim> S;  ///< R^T F, symmetric.
};

/// Returns the polar decomposition of one matrix, that of a batch of one.
template <int Dim>
Polar<Dim> polar(const Eigen::Matrix<double, Dim, Dim>& F) {
  Polar<Dim> result;
  polar(Dim, PolarBatch{F.data(), result.R.data(), result.S.data(), 1, 1});
  return result;
}

/// The result of symmetric_eigen() for one matrix: A = Q diag(lambda) Q^T.
template <int Dim>
struct EigenDecomposition {
  Eigen::Matrix<double, Dim, 1> lambda;  ///< The eigenvalues, in no particular order.
  Eigen::Matrix<double, Dim, Dim> Q;     ///< Rotation with the eigenvectors in columns.
};

/// Returns the eigen-decomposition of one symmetric matrix, that of a batch of one.
template <int Dim>
EigenDecomposition<Dim> symmetric_eigen(const Eigen::Matrix<double, Dim, Dim>& A) {
  EigenDecomposition<Dim> result;
  symmetric_eigen(Dim, EigenBatch{A.data(), result.lambda.data(), result.Q.data(), 1, 1});
  return result;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::linalg

#pragma once

// Plain descriptions of batches: no Eigen here, kernel files include this header.

#include <cstddef>

namespace isostretch::linalg {

/// A batch of signed singular value decompositions F = U diag(sigma) V^T of dim x dim matrices. Batches are
/// structures of arrays: entry e of matrix i is at data[e * stride + i], with the entries in column-major
/// order (e = row + dim * column) and stride >= count. Arrays need no alignment; output arrays may be null,
/// which skips them.
struct SvdBatch {
  const double* F = nullptr;  ///< The matrices to decompose, dim * dim entries each.
  double* U = nullptr;        ///< Rotations, dim * dim entries each.
  /// The signed singular values, dim entries each: sigma_0 >= ... >= |sigma_last|, the sign of det F in the
  /// last.
  double* sigma = nullptr;
  double* V = nullptr;     ///< Rotations, dim * dim entries each.
  std::size_t count = 0;   ///< The number of matrices.
  std::size_t stride = 0;  ///< The distance between the entries e and e + 1 of a matrix, at least count.
};

/// A batch of polar decompositions F = R S of dim x dim matrices, in the layout of SvdBatch.
struct PolarBatch {
  const double* F = nullptr;  ///< The matrices to decompose, dim * dim entries each.
  double* R = nullptr;        ///< The rotations closest to F, also for inverted F; dim * dim entries each.
  /// R^T F, symmetric, and indefinite where F is inverted; all dim * dim entries are written.
  double* S = nullptr;
  std::size_t count = 0;   ///< The number of matrices.
  std::size_t stride = 0;  ///< The distance between the entries e and e + 1 of a matrix, at least count.
};

/// A batch of eigen-decompositions A = Q diag(lambda) Q^T of symmetric matrices, in the layout of SvdBatch.
struct EigenBatch {
  const double* A = nullptr;  ///< The symmetric dim x dim matrices; the lower triangle is read.
  double* lambda = nullptr;   ///< The eigenvalues, dim each, in no particular order.
  double* Q = nullptr;        ///< Rotations with the eigenvectors in columns, dim * dim entries each.
  std::size_t count = 0;      ///< The number of matrices.
  std::size_t stride = 0;     ///< The distance between the entries e and e + 1 of a matrix, at least count.
};

}  // namespace isostretch::linalg

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

// Batches. dim is 2 or 3, and of symmetric_eigen 4 or 6 as well; anything else throws Error.
void signed_svd(int dim, const SvdBatch& batch);

void polar(int dim, const PolarBatch& batch);

// Takes less time where batch.Q is null.
void symmetric_eigen(int dim, const EigenBatch& batch);

// One matrix, with Eigen types. Inline, so that no Eigen type whose alignment depends on compiler flags
// crosses a compiled boundary; in the namespace of the caller's instruction set for the same reason.
inline namespace ISOSTRETCH_ISA {

template <int Dim>
struct SignedSvd {
  Eigen::Matrix<double, Dim, Dim> U;
  Eigen::Matrix<double, Dim, 1> sigma;
  Eigen::Matrix<double, Dim, Dim> V;
};

template <int Dim>
SignedSvd<Dim> signed_svd(const Eigen::Matrix<double, Dim, Dim>& F) {
  SignedSvd<Dim> result;
  signed_svd(Dim, SvdBatch{F.data(), result.U.data(), result.sigma.data(), result.V.data(), 1, 1});
  return result;
}

template <int Dim>
struct Polar {
  Eigen::Matrix<double, Dim, Dim> R;
  Eigen::Matrix<double, Dim, Dim> S;
};

template <int Dim>
Polar<Dim> polar(const Eigen::Matrix<double, Dim, Dim>& F) {
  Polar<Dim> result;
  polar(Dim, PolarBatch{F.data(), result.R.data(), result.S.data(), 1, 1});
  return result;
}

template <int Dim>
struct EigenDecomposition {
  Eigen::Matrix<double, Dim, 1> lambda;
  Eigen::Matrix<double, Dim, Dim> Q;
};

template <int Dim>
EigenDecomposition<Dim> symmetric_eigen(const Eigen::Matrix<double, Dim, Dim>& A) {
  EigenDecomposition<Dim> result;
  symmetric_eigen(Dim, EigenBatch{A.data(), result.lambda.data(), result.Q.data(), 1, 1});
  return result;
}

}  // namespace ISOSTRETCH_ISA
}  // namespace isostretch::linalg

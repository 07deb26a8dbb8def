#pragma once

// Plain descriptions of batches: no Eigen here, kernel files include this header.

#include <cstddef>

namespace isostretch::linalg {

// Batches are structures of arrays: entry e of matrix i is at data[e * stride + i], entries in column-major
// order (e = row + dim * column). stride >= count; arrays need no alignment; output arrays may be null to
// skip them. F = U diag(sigma) V^T.
struct SvdBatch {
  const double* F = nullptr;
  double* U = nullptr;      // rotations
  double* sigma = nullptr;  // dim entries: sigma_0 >= ... >= |sigma_last|, the sign of det F in the last
  double* V = nullptr;      // rotations
  std::size_t count = 0;
  std::size_t stride = 0;
};

struct PolarBatch {
  const double* F = nullptr;
  double* R = nullptr;  // the rotation closest to F (also for inverted F)
  double* S = nullptr;  // R^T F, symmetric, indefinite where F is inverted; all dim * dim entries are written
  std::size_t count = 0;
  std::size_t stride = 0;
};

struct EigenBatch {
  const double* A = nullptr;  // symmetric; the lower triangle is read
  double* lambda = nullptr;   // in no particular order
  double* Q = nullptr;        // rotations, eigenvectors in columns
  std::size_t count = 0;
  std::size_t stride = 0;
};

}  // namespace isostretch::linalg

#pragma once

#include <isostretch/sparse/matrix.hpp>

#include <vector>

namespace isostretch::sparse {

// The lower triangle of P A P^T with fixed pattern: the search for where values go is done once, afterwards
// new values cost one gather. (CHOLMOD left to itself permutes by two sorting transpositions at every
// factorization.)
class PermutedMatrix {
 public:
  PermutedMatrix() = default;
  // permutation: position -> unknown of A.
  PermutedMatrix(const SymmetricMatrix& A, const std::vector<int>& permutation);

  void gather(const SymmetricMatrix& A);
  const SymmetricMatrix& matrix() const { return matrix_; }
  SymmetricMatrix& matrix() { return matrix_; }

 private:
  SymmetricMatrix matrix_;
  std::vector<int> source_;  // entry -> entry of A
};

}  // namespace isostretch::sparse

#pragma once

#include "block_csr.hpp"

#include <vector>

namespace isostretch::sparse {

// Block Gauss-Seidel within chunks of rows, Jacobi between them; there the diagonal blocks are enlarged by
// the norms of what is left out, so that it converges whatever the chunks (Baker, Falgout, Kolev & Yang
// 2011). backward() is the transpose of forward(), which makes the cycle around them symmetric.
class GaussSeidel {
 public:
  // `inverse` gets the inverses of the diagonal blocks of A. Returns the row that shows A to be indefinite,
  // or -1.
  int setup(const BlockCsr<double>& A, double scale, std::vector<double>& inverse);

  // One sweep from x = 0, and r = b - A x on the way.
  void forward(const BlockCsr<float>& A, const float* b, float* x, float* r) const;
  // One sweep from the x there is.
  void backward(const BlockCsr<float>& A, const float* b, float* x);

 private:
  template <int B>
  void forward_chunk(const BlockCsr<float>& A, const float* b, float* x, int chunk) const;
  template <int B>
  void residual_rows(const BlockCsr<float>& A, const float* x, float* r, int begin, int end) const;
  template <int B>
  void backward_chunk(const BlockCsr<float>& A, const float* b, float* x, int chunk) const;

  std::vector<int> chunk_, chunk_of_;
  std::vector<float> inverse_;  // of the enlarged diagonal blocks
  std::vector<float> added_;    // to their diagonals
  std::vector<float> before_;
};

}  // namespace isostretch::sparse

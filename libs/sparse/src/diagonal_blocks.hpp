#pragma once

#include "block_csr.hpp"

namespace isostretch::sparse {

// The row (not block row) where a diagonal block has no positive pivot, or -1.
int indefinite_diagonal(const BlockCsr<double>& A);
// The largest magnitude on the diagonal.
double largest_diagonal(const BlockCsr<double>& A);

}  // namespace isostretch::sparse

#pragma once

#include "block_csr.hpp"

#include <vector>

namespace isostretch::sparse {

// Entries (one flag each) whose blocks couple strongly: |A_ij|_F^2 > threshold^2 |A_ii|_F |A_jj|_F. The
// diagonal counts as strong.
std::vector<char> strong_couplings(const BlockCsr<double>& A, double threshold);

// A with weak blocks added to the diagonal block of their row instead, which keeps translations.
BlockCsr<double> lump_weak(const BlockCsr<double>& A, const std::vector<char>& strong);

struct Aggregates {
  std::vector<int> of;  // aggregate of each node; -1: node without strong coupling, left to the smoother
  int count = 0;
};

// Disjoint neighbourhoods of the strong graph (Vanek, Mandel & Brezina 1996).
Aggregates aggregate(const BlockCsr<double>& A, const std::vector<char>& strong);

}  // namespace isostretch::sparse

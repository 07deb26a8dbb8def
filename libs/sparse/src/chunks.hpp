#pragma once

#include <algorithm>
#include <vector>

namespace isostretch::sparse {

// Ranges of block rows that sequential sweeps (Gauss-Seidel, triangular solutions) run over side by side, as
// if the couplings between ranges were Jacobi's. They depend on the size alone, not on the number of threads.
inline std::vector<int> chunk_starts(int rows) {
  constexpr int rows_in_chunk = 4096, most = 64;
  const int count = std::clamp(rows / rows_in_chunk, 1, most);
  std::vector<int> start;
  for (int c = 0; c <= count; ++c)
    start.push_back(static_cast<int>(static_cast<long long>(rows) * c / count));
  return start;
}

}  // namespace isostretch::sparse

#pragma once

#include "aggregation.hpp"
#include "node_system.hpp"

#include <vector>

namespace isostretch::sparse {

// What an elastic body does without energy, or nearly: values at every row of a level, `count` a row.
struct NearNullspace {
  int count = 0;
  std::vector<double> mode;  // mode[row * count + c]
};

// On the mesh: translations, and rotations about the middle where the coordinates are known.
NearNullspace near_nullspace(const NodeSystem& system, const Coordinates& coordinates);

// Modes restricted to each aggregate and made orthonormal there: `coarse` gets them in the new basis. Modes
// that depend on others on an aggregate leave a zero column.
BlockCsr<double> tentative_prolongator(const NearNullspace& modes, int height, const Aggregates& aggregates,
                                       NearNullspace& coarse);

// (I - omega D^-1 A) T with omega for the largest eigenvalue of D^-1 A, D the diagonal blocks of `system` and
// A the matrix without weak couplings. `inverse` has the blocks of D^-1.
BlockCsr<double> smoothed_prolongator(const BlockCsr<double>& system, const BlockCsr<double>& filtered,
                                      const std::vector<double>& inverse, const BlockCsr<double>& tentative);

}  // namespace isostretch::sparse

#pragma once

#include "free_system.hpp"

#include <isostretch/handles/bounded_weights.hpp>

#include <string>
#include <vector>

namespace isostretch::handles {

// What the weights of all handles have in common.
struct WeightSystem {
  const Rows& stiffness;
  const Rows& squared;  // A = K M^-1 K
  const FreeSystem& free_system;
  std::vector<double> diagonal;  // of A, 1 where it is zero
};

// Minimises 1/2 w^T A w over 0 <= w <= 1 at the nodes that are unknown, beginning with the w given; w at all
// others stays. `start` are the nodes of the handle, `name` begins the Error when max_iterations do not
// suffice.
WeightReport minimize_bounded(const WeightSystem& system, const std::vector<bool>& unknown,
                              const std::vector<int>& start, const WeightOptions& options,
                              const std::string& name, std::vector<double>& w);

}  // namespace isostretch::handles

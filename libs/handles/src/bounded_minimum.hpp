#pragma once

#include "free_system.hpp"
#include "relaxation.hpp"

#include <isostretch/handles/bounded_weights.hpp>

#include <string>
#include <vector>

namespace isostretch::handles {

// What the weights of all handles have in common: A = K M^-1 K, for sweeps and for systems.
struct WeightSystem {
  const Relaxation& relaxation;
  const FreeSystem& free_system;
};

// Minimises 1/2 w^T A w over 0 <= w <= 1 at the nodes that are unknown, ascending, beginning with the minimum
// without bounds; w at all others stays. `name` begins the Error when max_iterations do not suffice.
WeightReport minimize_bounded(const WeightSystem& system, const std::vector<int>& unknown,
                              const WeightOptions& options, const std::string& name, std::vector<double>& w);

}  // namespace isostretch::handles

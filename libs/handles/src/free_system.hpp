#pragma once

#include "stiffness.hpp"

#include <isostretch/sparse/options.hpp>

#include <vector>

namespace isostretch::handles {

// Systems A w = 0 at some nodes with w given at all others, for A = K M^-1 K and any choice of nodes.
class FreeSystem {
 public:
  // Rows are referred to.
  FreeSystem(const Rows& stiffness, const Rows& squared, int dim, const sparse::Options& solver);

  // Replaces w, `columns` vectors one after the other, at the nodes that are free. Throws Error when the
  // system cannot be solved.
  void solve(const std::vector<bool>& free, std::vector<double>& w, int columns) const;

 private:
  const Rows& squared_;
  int dim_;
  sparse::Options solver_;
  std::vector<int> order_;  // nodes, those of a group one after the other
  std::vector<int> group_;  // of every node
};

}  // namespace isostretch::handles

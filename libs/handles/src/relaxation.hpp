#pragma once

#include "stiffness.hpp"

#include <isostretch/core/index.hpp>

#include <vector>

namespace isostretch::handles {

// The energy 1/2 w^T A w, node by node. A is kept in one piece: it is read some hundreds of times.
class Relaxation {
 public:
  explicit Relaxation(const Rows& A);

  // (A v)_n.
  double product(int n, const std::vector<double>& v) const;
  // The same over A_nn, or over 1 where that is zero.
  double scaled_product(int n, const std::vector<double>& v) const {
    return product(n, v) / diagonal_[at(n)];
  }

  // Projected successive over-relaxation (Cryer 1971): every one of the nodes in turn, there and back again,
  // goes beyond the place where the energy is least, and not beyond 0 or 1. The energy never rises.
  void relax(const std::vector<int>& nodes, std::vector<double>& w) const;

 private:
  void relax_node(int n, std::vector<double>& w) const;

  std::vector<std::size_t> start_;  // of the rows; one more than there are
  std::vector<int> column_;
  std::vector<double> value_;
  std::vector<double> diagonal_;
};

}  // namespace isostretch::handles

#pragma once

#include "system.hpp"

#include <isostretch/sparse/solver.hpp>

#include <memory>
#include <vector>

namespace isostretch::sdp_penalty {

// Solves with H0, factorised once: the minimiser without constraints, and lower bounds.
class Unconstrained {
 public:
  explicit Unconstrained(const sparse::Options& options);

  // For this system from here on; true when H0 had to be factorised. Throws Error when it is singular.
  bool refresh(const System& system);

  Vector minimiser() const;

  // A bound on the energy of every feasible x, from the energy and its gradient at any, and any positive
  // semi-definite multipliers.
  double lower_bound(const Vector& gradient, double energy, const Constrained& at_x,
                     const Constrained& multipliers) const;

 private:
  Vector solved(const Vector& right) const;

  const System* system_ = nullptr;
  std::unique_ptr<sparse::Solver> solver_;
  std::vector<double> factorised_;  // values of H0
};

}  // namespace isostretch::sdp_penalty

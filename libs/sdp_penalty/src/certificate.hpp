#pragma once

#include "system.hpp"

#include <isostretch/sparse/solver.hpp>

#include <memory>

namespace isostretch::sdp_penalty {

// Solves with H0, factorised once: the minimiser without constraints, and lower bounds.
class Unconstrained {
 public:
  // Throws Error when H0 is singular: some component has no target.
  Unconstrained(const System& system, const sparse::Options& options);

  Vector minimiser() const;

  // A bound on the energy of every x with S_i >= margin I, for any positive semi-definite Y.
  double lower_bound(const Vector& x, const std::vector<double>& S, const std::vector<double>& Y,
                     double margin) const;

 private:
  Vector solved(const Vector& right) const;

  const System& system_;
  std::unique_ptr<sparse::Solver> solver_;
};

}  // namespace isostretch::sdp_penalty

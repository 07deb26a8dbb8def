#pragma once

#include "system.hpp"

#include <vector>

namespace isostretch::sdp_penalty {

// What a penalty is at some S.
struct PenaltyState {
  std::vector<double> value;  // one an element
  Blocks multiplier;          // - d phi / d S, positive semi-definite
  SpectralCurvature curvature;
  double largest = 0;  // of the eigenvalues that it looks at

  void resize(std::size_t elements, std::size_t entries);
  double sum() const;
  int active() const;
};

// A convex term phi = sum over elements phi_i(S_i) beside the energy, which keeps the S_i, or drives them,
// into the cone. What the penalty path and the augmented Lagrangians differ in.
class ConePenalty {
 public:
  virtual ~ConePenalty();
  virtual void evaluate(int dim, const Blocks& S, PenaltyState& state) const = 0;
  // One an element; infinity outside the domain.
  virtual std::vector<double> values(int dim, const Blocks& S) const = 0;
  // Its largest curvature, by which rounding of S counts.
  virtual double stiffness() const = 0;
};

}  // namespace isostretch::sdp_penalty

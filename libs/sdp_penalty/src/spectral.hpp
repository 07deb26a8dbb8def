#pragma once

#include "system.hpp"

#include <isostretch/sdp_penalty/options.hpp>

#include <vector>

namespace isostretch::sdp_penalty {

// phi = sum over elements and eigenvalues y of S_i - offset I - shift_i of p(y), with the penalties of
// options.hpp, tau included. The shift makes it an augmented Lagrangian: Y / (2 tau).
struct SpectralPenalty {
  Penalty kind = Penalty::quadratic;
  double tau = 1;
  double offset = 0;
  const Blocks* shift = nullptr;
};

// What it is at some S.
struct SpectralState {
  std::vector<double> value;  // one an element
  Blocks multiplier;          // - d phi / d S, positive semi-definite
  SpectralCurvature curvature;
  double largest = 0;  // |y|

  double sum() const;
  int active() const;
};

std::vector<double> values(const SpectralPenalty& penalty, int dim, const Blocks& S);
void evaluate(const SpectralPenalty& penalty, int dim, const Blocks& S, SpectralState& state);

}  // namespace isostretch::sdp_penalty

#pragma once

#include "cone_penalty.hpp"

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

std::vector<double> values(const SpectralPenalty& penalty, int dim, const Blocks& S);
void evaluate(const SpectralPenalty& penalty, int dim, const Blocks& S, PenaltyState& state);

// The same as a term of the path.
class SpectralTerm final : public ConePenalty {
 public:
  SpectralPenalty penalty;

  void evaluate(int dim, const Blocks& S, PenaltyState& state) const override {
    sdp_penalty::evaluate(penalty, dim, S, state);
  }
  std::vector<double> values(int dim, const Blocks& S) const override {
    return sdp_penalty::values(penalty, dim, S);
  }
  double stiffness() const override { return penalty.tau; }
};

}  // namespace isostretch::sdp_penalty

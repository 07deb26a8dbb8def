#pragma once

#include "cone_penalty.hpp"
#include "progress.hpp"

namespace isostretch::sdp_penalty {

// Minimises f + phi from x by Newton's method, one penalty after the other: what the penalty path and the
// augmented Lagrangians share.
class Path {
 public:
  // x must satisfy hard targets. It becomes each iterate in turn.
  Path(Workspace& work, const Options& options, Progress& progress, Vector& x);

  enum class End {
    tolerance,  // the decrement is small enough, or rounding leaves no more to gain
    limit,      // level_iterations
    progress    // the whole solve has ended
  };

  // Until the decrement is this share of the energy, or, where x is feasible and only the gap is left to
  // close, in the noise of rounding.
  End minimise(const ConePenalty& penalty, double tolerance);
  // Until g^T H^-1 g < 1e-14, with Armijo's rule on sums.
  End minimise_as_published(const ConePenalty& penalty);

  // Of the last penalty at x.
  const Blocks& multiplier() const { return state_.multiplier; }

 private:
  End minimise(bool published, double tolerance);
  bool newton_step();
  double decrement_to_reach(double tolerance) const;
  bool search(bool published);
  double change(double step) const;
  double change_of_sums(double step) const;
  double noise() const;
  void take_step();

  Workspace& work_;
  const Options& options_;
  Progress& progress_;
  Vector& x_;
  const ConePenalty* penalty_ = nullptr;
  PenaltyState state_;
  Blocks S_, change_of_S_;
  Vector gradient_, dx_;
  double decrement_ = 0, step_ = 0;
};

}  // namespace isostretch::sdp_penalty

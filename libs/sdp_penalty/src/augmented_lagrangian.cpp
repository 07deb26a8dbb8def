#include "methods.hpp"
#include "path.hpp"
#include "spectral.hpp"

#include <algorithm>
#include <limits>

namespace isostretch::sdp_penalty {

void augmented_lagrangian(Workspace& work, const Options& options, Progress& progress, Vector& x) {
  const AugmentedLagrangianOptions& own = options.augmented_lagrangian;
  constexpr int most_rounds = 1000;  // where rounds no longer move anything
  const bool warm = own.warm_start && work.last_Y.size() > 0;
  Blocks Y(work.system.blocks() * work.system.block_size(), 0.0), shift(Y.size());
  SpectralTerm term;
  SpectralPenalty& penalty = term.penalty;
  penalty.tau = own.first;
  double epsilon = own.epsilon;
  penalty.offset = work.system.problem().margin + epsilon;
  penalty.shift = &shift;
  if (warm) {
    x = work.system.with_hard_targets(work.last_x);
    Y = work.last_Y;
    penalty.tau = work.last_tau;
  }
  Path path(work, options, progress, x);
  double tolerance = 1e-8;
  double violation = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds && !progress.ended(); ++round) {
    for (std::size_t k = 0; k < Y.size(); ++k) shift[k] = Y[k] / (2 * penalty.tau);
    path.minimise(term, tolerance);
    tolerance = std::max(0.1 * tolerance, 1e-14);  // multipliers are as good as the minimiser is
    Y = path.multiplier();
    const double left = std::max(0.0, penalty.offset - progress.last().min_eigenvalue);
    if (left > 0.25 * violation) penalty.tau = std::min(own.factor * penalty.tau, own.last);
    violation = left;
    // Feasible with multipliers that have settled: only epsilon keeps the gap open.
    if (left <= 0.1 * epsilon && !progress.ended()) {
      epsilon *= 0.25 * std::min(1.0, options.gap_tolerance / progress.gap());
      penalty.offset = work.system.problem().margin + epsilon;
      violation = std::numeric_limits<double>::infinity();
    }
  }
  if (!progress.ended()) progress.give_up(Status::path_end, "the multipliers did not settle", x, {Y, {}});
  work.last_Y.clear();
  if (!progress.certified()) return;
  work.last_x = x;
  work.last_Y = std::move(Y);
  work.last_tau = penalty.tau;
}

}  // namespace isostretch::sdp_penalty

#pragma once

#include <isostretch/sdp_penalty/solver.hpp>

#include <functional>
#include <vector>

namespace isostretch::sdp_penalty {

/// How solve_relinearized() goes about it.
struct RelinearizeOptions {
  /// The options of the convex problems.
  Options solve;
  /// The largest number of rounds.
  int max_rounds = 100;
  /// Ends when a round lowers the energy (with each element's own nearest rotation) by less than this share.
  double tolerance = 1e-6;
  /// Penalty factor of the penalty solution that a round starts over from when ex-rotations are infeasible.
  double soft_penalty = 1e4;

  /// Throws Error naming the first option that makes no sense.
  void validate() const;
};

/// One convex problem of solve_relinearized().
struct RelinearizeRound {
  /// How the convex problem of this round ended.
  Status status = Status::not_run;
  bool penalty_solution = false;  ///< it was infeasible: this is the penalty solution
  /// The number of iterations of the round.
  int iterations = 0;
  /// The number of linear solves of the round.
  int linear_solves = 0;
  /// With the nearest rotation of every F in the place of R: what falls from round to round, once feasible.
  double energy = 0;
  double min_eigenvalue = 0;  ///< with the rotations that the round was given
  /// The number of inverted elements after the round.
  int inverted = 0;
  /// Wall time of the round.
  double seconds = 0;
};

/// The result of solve_relinearized().
struct RelinearizeSummary {
  bool settled = false;  ///< by the tolerance
  bool stopped = false;  ///< by the callback
  /// The summary of the last round's convex problem; of its penalty solution where it has no feasible x.
  Summary last;
  /// The rounds, in their order.
  std::vector<RelinearizeRound> rounds;
  /// The rotations that the last round was given, [element][dim * dim]: `last` is about these.
  std::vector<double> rotations;
};

/// Called after every round with its positions.
using RoundCallback = std::function<CallbackAction(const RelinearizeRound&, const Vector& x)>;

/// Solves the problem without given rotations, minimise over x and R, det F >= 0 (not convex): one convex
/// problem after the other, with R_i the nearest rotations of the round before (Kovalsky, Aigerman, Basri,
/// Lipman 2014).
///
/// The first round has the problem's own. A feasible x stays feasible in the next round, and the energy does
/// not rise. Where a field of ex-rotations is infeasible its penalty solution (the quadratic penalty at
/// soft_penalty, inversions and all) gives those of the next round.
RelinearizeSummary solve_relinearized(const Problem& problem, Vector& x,
                                      const RelinearizeOptions& options = {},
                                      const RoundCallback& callback = {});

/// Minimises the energy plus soft_penalty times the squares of the eigenvalues of S_i - margin I below 0. It
/// does not know largest_stretch.
Summary penalty_solution(const Problem& problem, Vector& x, double soft_penalty, const Options& options = {});

/// Returns the nearest rotations of F = sum x_a g_a^T, [element][dim * dim] column by column, determinant 1;
/// the identity for a collapsed element.
std::vector<double> nearest_rotations(const assembly::Elements& elements, const Vector& x);

}  // namespace isostretch::sdp_penalty

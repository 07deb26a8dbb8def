#pragma once

#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/options.hpp>
#include <isostretch/sdp_penalty/problem.hpp>
#include <isostretch/sdp_penalty/summary.hpp>

#include <functional>
#include <memory>

namespace isostretch::sdp_penalty {

using isostretch::CallbackAction;
/// Called for every row of the trace with its positions.
using IterationCallback = std::function<CallbackAction(const Iteration&, const Vector& x)>;

/// Solves one problem after the other, as dragging a handle makes them, and keeps what does not change.
///
/// Kept are the sparsity with its analysis as long as elements and hard targets are on the same nodes,
/// and the factor of H0 as long as weights, gradients, alpha and the nodes of targets are the same (with
/// incompressibility also the ex-rotations). Results are those of a new Solver, to the bit, but for warm
/// starts.
class Solver {
 public:
  /// Throws Error for options that make no sense.
  explicit Solver(const Options& options = {});
  ~Solver();
  /// Takes over another solver with what it keeps.
  Solver(Solver&&) noexcept;
  /// Takes over another solver with what it keeps.
  Solver& operator=(Solver&&) noexcept;

  /// Solves a problem; x becomes the result and may be empty on entry: what it holds does not matter. Every
  /// iterate can be shown as a preview. Throws Error for misuse; numerical outcomes are the Summary's status.
  ///
  /// The bound is rigorous at every iterate, for any multipliers Y_i >= 0 (weak duality): the energy of every
  /// feasible position is at least f(x) - sum <Y_i, S_i - margin I> - 1/2 r^T H0^-1 r with r the gradient of
  /// the Lagrangian. Every method ends when x is feasible and the bound within gap_tolerance. A body far from
  /// the origin is solved for at the origin: the Summary is that of x before it is moved back, which rounds.
  Summary solve(const Problem& problem, Vector& x, const IterationCallback& callback = {});

 private:
  Summary solve_here(const Problem& problem, Vector& x, const IterationCallback& callback);

  struct State;
  Options options_;
  std::unique_ptr<State> state_;
};

/// Solves a problem with a Solver for it alone.
Summary solve(const Problem& problem, Vector& x, const Options& options = {},
              const IterationCallback& callback = {});

}  // namespace isostretch::sdp_penalty

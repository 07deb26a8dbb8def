#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>
#include <isostretch/sdp_penalty/summary.hpp>
#include <isostretch/sparse/options.hpp>

#include <functional>

namespace isostretch::sdp_penalty {

enum class CallbackAction { proceed, stop };
using IterationCallback = std::function<CallbackAction(const Iteration&, const Vector& x)>;

struct InteriorPointOptions {
  // A factorization: systems near the boundary are too badly conditioned for anything else, and the bound is
  // rigorous only as far as H0 is solved with exactly.
  InteriorPointOptions() { solver.backend = sparse::available_backends().front(); }

  double gap_tolerance = 1e-6;  // certified, relative
  int max_iterations = 60;
  double step_fraction = 0.99;    // of the way to the boundary
  double least_eigenvalue = 0.1;  // of the slacks at the start
  sparse::Options solver;

  // Throws Error naming the first option that makes no sense.
  void validate() const;
};

// Primal-dual interior point on the slack form Z_i = S_i(x) - margin I (Nesterov-Todd scaling, Mehrotra's
// predictor and corrector), with the sparsity of the elasticity: one factorization an iteration, from the
// minimiser without constraints, without line search or penalty factor. x becomes the result and may be empty
// on entry.
//
// The bound is rigorous at every iterate, for any multipliers Y_i >= 0 (weak duality): the energy of every
// feasible position is at least f(x) - sum <Y_i, S_i - margin I> - 1/2 r^T H0^-1 r with r the gradient of the
// Lagrangian. It ends when x is feasible and the bound within gap_tolerance. Throws Error for misuse;
// numerical outcomes are the Summary's status.
Summary solve_interior_point(const Problem& problem, Vector& x, const InteriorPointOptions& options = {},
                             const IterationCallback& callback = {});

}  // namespace isostretch::sdp_penalty

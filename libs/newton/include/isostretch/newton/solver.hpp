#pragma once

#include <isostretch/core/solve_status.hpp>
#include <isostretch/core/vector.hpp>
#include <isostretch/newton/objective.hpp>
#include <isostretch/newton/options.hpp>
#include <isostretch/newton/summary.hpp>
#include <isostretch/sparse/solver.hpp>

#include <functional>
#include <memory>

namespace isostretch::newton {

using isostretch::CallbackAction;

/// Called after the start and after every iteration with the row just added to the trace and the positions. A
/// callback may take them as an Eigen::VectorXd: they are copied then.
using IterationCallback = std::function<CallbackAction(const Iteration&, const Vector& x)>;

/// Projected Newton for an objective that is minimised again and again: the frames of a sequence, time steps,
/// drags.
///
/// The linear solver is kept from one solve to the next, and so are the pattern of the Hessian, the
/// fill-reducing ordering and the symbolic factorization, until the objective's pattern changes (terms that
/// are added, pins, equality constraints). Where only a stencil moves (Term::has_moving_stencil) the ordering
/// stays and the factorization is analyzed again. Iterative linear solvers are analyzed anew for every solve,
/// so that a solve does not depend on those before it. One solver is used by one thread at a time.
class Solver {
 public:
  /// The objective must outlive the solver, and may change between solves, not during one. A linear solver
  /// that is handed in takes the place of the one that `options.solver` describes. Throws Error for options
  /// that make no sense.
  explicit Solver(Objective& objective, const Options& options = {},
                  std::unique_ptr<sparse::Solver> linear_solver = nullptr);
  ~Solver();
  /// Takes over another solver with what it keeps.
  Solver(Solver&&) noexcept;
  /// Takes over another solver with what it keeps.
  Solver& operator=(Solver&&) noexcept;

  /// Minimises from x (dim * node_count entries, node by node), which ends as the best positions found, also
  /// when the solve fails or is stopped; the energy never rises. Throws Error for misuse (sizes, an objective
  /// without terms); numerical outcomes are the Summary's status.
  Summary solve(Vector& x, const IterationCallback& callback = {});

  /// Begins a solve that is taken step by step, from x as solve() does. Returns whether there is a step to
  /// take.
  bool start(Vector x);
  /// Takes one iteration. Returns whether another one is to come: false once summary() has a status other
  /// than not_run. Throws Error before start(), and when the objective was given terms, pins or equality
  /// constraints since.
  bool step();
  /// Returns the best positions so far of the solve that start() began. Throws Error before start().
  const Vector& positions() const;
  /// Returns the summary so far of the solve that start() began. Throws Error before start().
  const Summary& summary() const;

  /// Sets the options of the solves that follow. Throws Error for options that make no sense. Other `solver`
  /// options than before make another linear solver, unless one was handed in.
  void set_options(const Options& options);
  /// Returns the options of the next solve.
  const Options& options() const;

  /// Returns how often an analysis with a new ordering was made, over all solves.
  int analyses() const;

 private:
  class Solve;
  struct Workspace;
  void require_startable(const Vector& x) const;

  std::unique_ptr<Workspace> workspace_;
  std::unique_ptr<Solve> current_;
};

}  // namespace isostretch::newton

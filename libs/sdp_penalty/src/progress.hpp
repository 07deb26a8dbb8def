#pragma once

#include "certificate.hpp"
#include "system.hpp"

#include <isostretch/core/iteration_driver.hpp>
#include <isostretch/sdp_penalty/solver.hpp>

#include <memory>
#include <string>
#include <utility>

namespace isostretch::sdp_penalty {

// What is kept from one problem to the next.
struct Workspace {
  Workspace(const Problem& problem, const Options& options);

  System system;
  Unconstrained unconstrained;
  // Of Newton systems: set its values, and factorise; the solver is analyzed when first asked for.
  sparse::SymmetricMatrix matrix;
  sparse::FactorResult factorize();
  // The Newton direction over all degrees of freedom, and g^T H^-1 g.
  struct Direction {
    Vector dx;
    double decrement = 0;
  };
  Direction direction(const Vector& gradient);

  // Of the solve before, where the next may start.
  Vector last_x;
  Blocks last_Y;
  double last_tau = 0;

 private:
  sparse::Solver& newton_solver();

  sparse::Options options_;
  std::unique_ptr<sparse::Solver> newton_solver_;
};

// The trace of a solve, its bound and its end: the same for every method.
class Progress {
 public:
  Progress(Workspace& work, const Options& options, const IterationCallback& callback);

  // The next iterate, what is constrained there, and multipliers >= 0 for the bound. `row` brings what the
  // method alone knows. Ends the solve when x is feasible and the gap closed, when x is not finite, and when
  // the callback says so.
  void record(Iteration row, const Vector& x, const Constrained& at_x, const Constrained& multipliers);
  bool ended() const { return driver_.ended(); }
  void end(Status status, std::string message) { driver_.end(status, std::move(message)); }
  // Names infeasible_elements by their multipliers, and calls it infeasible where these prove it.
  void give_up(Status status, const std::string& reason, const Vector& x, const Constrained& multipliers);

  // The same where max_iterations is reached; true when it is.
  bool give_up_at_limit(const Vector& x, const Constrained& multipliers);
  // The same as infeasible when the multipliers prove it already; true when it did.
  bool give_up_contradicted(const Vector& x, const Constrained& multipliers);

  void count_solve() { ++summary_.linear_solves; }
  void count_iteration() { ++summary_.iterations; }
  const Iteration& last() const { return summary_.trace.back(); }
  // Of the objective at the last x.
  const Vector& gradient() const { return gradient_; }
  bool feasible() const { return last().infeasible == 0; }
  double gap() const { return gap(last()); }
  bool certified() const { return certified(last()); }  // feasible, and the gap is within the tolerance
  Summary finish(const Vector& x);

 private:
  double gap(const Iteration& row) const;
  bool certified(const Iteration& row) const;
  void name_infeasible_elements(const Constrained& multipliers);
  bool contradiction(const Vector& x, Blocks Y);
  void count_infeasible(Iteration& row, const Constrained& at_x) const;

  Workspace& work_;
  const Options& options_;
  bool ends_at_certificate_;  // Algorithm 1 as published does not
  Vector gradient_;
  Summary summary_;
  IterationDriver<Summary> driver_;
};

}  // namespace isostretch::sdp_penalty

#pragma once

#include "certificate.hpp"
#include "system.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/sdp_penalty/solver.hpp>

#include <memory>
#include <string>

namespace isostretch::sdp_penalty {

// What is kept from one problem to the next.
struct Workspace {
  Workspace(const Problem& problem, const Options& options);

  System system;
  Unconstrained unconstrained;
  // Of Newton systems; analyzed when first asked for.
  sparse::Solver& newton_solver();
  sparse::SymmetricMatrix matrix;

  // Of the solve before, where the next may start.
  Vector last_x;
  Blocks last_Y;
  double last_tau = 0;

 private:
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
  bool ended() const { return summary_.status != Status::not_run; }
  void end(Status status, std::string message);
  // Names suspects by their multipliers, and calls it inadmissible where these prove it.
  void give_up(Status status, const std::string& reason, const Vector& x, const Constrained& multipliers);

  // The same as inadmissible when the multipliers prove it already; true when it did.
  bool give_up_contradicted(const Vector& x, const Constrained& multipliers);

  void count_solve() { ++summary_.linear_solves; }
  void count_iteration() { ++summary_.iterations; }
  int iterations() const { return summary_.iterations; }
  const Iteration& last() const { return summary_.trace.back(); }
  // Of the objective at the last x.
  const Vector& gradient() const { return gradient_; }
  bool feasible() const { return last().infeasible == 0; }
  double gap() const;
  bool certified() const;  // feasible, and the gap is within the tolerance
  Summary finish(const Vector& x);

 private:
  void name_suspects(const Constrained& multipliers);
  bool contradiction(const Vector& x, Blocks Y);
  void count_infeasible(Iteration& row, const Constrained& at_x) const;

  Workspace& work_;
  const Options& options_;
  const IterationCallback& callback_;
  bool ends_at_certificate_;  // Algorithm 1 as published does not
  Timer timer_;
  Vector gradient_;
  Summary summary_;
};

}  // namespace isostretch::sdp_penalty

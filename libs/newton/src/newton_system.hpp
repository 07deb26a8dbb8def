#pragma once

#include <isostretch/newton/objective.hpp>
#include <isostretch/sparse/solver.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace isostretch::newton {

// The linear systems of an objective: its Hessian over the unknowns, and the linear solver with its analysis,
// which are kept from one solve to the next.
class NewtonSystem {
 public:
  // linear: null where `options` say which one.
  NewtonSystem(Objective& objective, std::unique_ptr<sparse::Solver> linear)
      : objective_(&objective), handed_in_(linear != nullptr), linear_(std::move(linear)) {}

  Objective& objective() const { return *objective_; }

  // At the start of a solve from x: makes the analysis, or takes the one there is for this pattern.
  void prepare(const Vector& x, const sparse::Options& options);
  // Takes the pattern of stencils that have moved, if they have. Before the objective is differentiated.
  void follow_stencils();
  // The Hessian of the objective's last differentiate(). Returns whether it is finite.
  bool assemble();

  // Adds a shift to the diagonal (it adds up until the next assemble()) and factorises.
  sparse::FactorResult factorize(const Vector& x, double shift);
  sparse::SolveResult solve(const Vector& right, Vector& solution);
  void set_tolerance(double tolerance) { linear_->set_tolerance(tolerance); }

  int size() const { return matrix_.size; }
  int nonzeros() const { return matrix_.nonzeros(); }
  // Median of the diagonal of the Hessian last assembled.
  double typical_stiffness() const { return typical_stiffness_; }
  int analyses() const { return analyses_; }
  // Null where nothing has been solved with it.
  const sparse::Solver* solver() const { return matrix_.size > 0 ? linear_.get() : nullptr; }
  // Makes another one next time, unless it was handed in.
  void drop_solver();

 private:
  void analyze(const Vector& x, const sparse::Options& options);
  bool has_analysis() const;
  void update_coordinates(const Vector& x);
  double& diagonal_entry(int j);
  void measure_stiffness();

  Objective* objective_;
  bool handed_in_;
  std::unique_ptr<sparse::Solver> linear_;
  int analyzed_version_ = -1;  // of the objective
  int stencil_version_ = -1;   // of the objective, that the matrix has
  int analyses_ = 0;
  sparse::SymmetricMatrix matrix_;
  std::vector<int> axes_;  // of the unknowns
  double typical_stiffness_ = 0;
};

}  // namespace isostretch::newton

#pragma once

#include "constraint_functions.hpp"
#include "nonlinear_program.hpp"
#include "objective.hpp"
#include "recorder.hpp"

#include <vector>

namespace isostretch::baselines {

// minimise f(x) - t  such that  c(x) >= 0. Hard targets are bounds that meet. The shift t, if the constraint
// functions have one, is below `most_shift`. Iterates go to the recorder.
class ConstrainedProgram final : public NonlinearProgram {
 public:
  // All must outlive this.
  ConstrainedProgram(const Instance& instance, const Objective& objective,
                     const ConstraintFunctions& constraints, Recorder& recorder);

  // The start, dim entries a node, and then the shift, if any.
  void start_at(const std::vector<double>& unknowns) { unknowns_ = unknowns; }
  // Ends as soon as the shift of an iterate is above the first.
  void look_for_shift(double enough, double most);

  Vector positions() const;  // the last that was shown, in the end the answer
  double shift() const { return unknowns_.back(); }
  bool has_enough() const { return constraints_.with_shift() && shift() > enough_shift_; }
  int last_iteration() const { return last_iteration_; }  // -1: none was shown

  Sizes sizes() const override;
  void bounds(std::span<double> lower, std::span<double> upper) const override;
  void start(std::span<double> x) const override;
  double value(std::span<const double> x) const override;
  void gradient(std::span<const double> x, std::span<double> g) const override;
  void constraints(std::span<const double> x, std::span<double> c) const override;
  void jacobian_structure(std::span<int> rows, std::span<int> columns) const override;
  void jacobian(std::span<const double> x, std::span<double> values) const override;
  void hessian_structure(std::span<int> rows, std::span<int> columns) const override;
  void hessian(std::span<const double> x, double factor, std::span<const double> multipliers,
               std::span<double> values) const override;
  bool take_iterate(int iteration, std::span<const double> x) override;
  void finish(std::span<const double> x) override;

 private:
  Vector positions_of(std::span<const double> x) const;
  int position_count() const;

  const Instance& instance_;
  const Objective& objective_;
  const ConstraintFunctions& constraints_;
  Recorder& recorder_;
  std::vector<double> unknowns_;
  double enough_shift_ = 0, most_shift_ = 0;
  int last_iteration_ = -1, first_point_;
};

}  // namespace isostretch::baselines

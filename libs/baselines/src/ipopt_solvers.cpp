// Ipopt on the principal minors and on cones, in the table also where this is built without it.
#include "constrained_program.hpp"
#include "registry.hpp"
#include "solver_module.hpp"
#include "unconstrained.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;

// x, and with constraints that have a shift one that makes all of them positive.
std::vector<double> unknowns_from(const sdp_penalty::Problem& problem, const Vector& x, bool with_shift) {
  std::vector<double> unknowns(x.begin(), x.end());
  if (with_shift) unknowns.push_back(measure(problem, x).min_eigenvalue - problem.margin - 0.1);
  return unknowns;
}

// The iterations are those of both phases together.
ProgramOutcome optimize(ConstrainedProgram& program, const Options& options, Recorder& recorder) {
  ProgramOptions limits;
  limits.tolerance = options.tolerance;
  if (options.limits.iterations > 0)
    limits.iterations = std::max(0, options.limits.iterations - recorder.iterations());
  ProgramOutcome outcome;
  load_solver("isostretch_ipopt", "isostretch_solve_by_ipopt")(program, limits, outcome);
  recorder.result().iterations += std::max(0, program.last_iteration());
  return outcome;
}

Vector optimize_energy(const Instance& instance, ConstraintForm form, const Vector& start,
                       const Options& options, Recorder& recorder) {
  const EnergyObjective objective(instance.problem);
  const ConstraintFunctions constraints(instance.problem, form);
  ConstrainedProgram program(instance, objective, constraints, recorder);
  program.start_at(unknowns_from(instance.problem, start, false));
  recorder.begin(Phase::solving);
  const auto [status, message] = optimize(program, options, recorder);
  recorder.end(status, message);
  return program.positions();
}

// weight / 2 |x - x0|^2: what keeps the search for a feasible position near.
class Nearness : public Objective {
 public:
  Nearness(Vector middle, double weight) : middle_(std::move(middle)), weight_(weight) {}
  double value(const Vector& x) const override { return 0.5 * weight_ * (x - middle_).squaredNorm(); }
  void gradient(const Vector& x, std::span<double> g) const override {
    Eigen::Map<Vector>(g.data(), x.size()) = weight_ * (x - middle_);
  }
  void add_hessian(int, double, std::span<double>, int) const override {}
  double hessian_diagonal(int) const override { return weight_; }

 private:
  Vector middle_;
  double weight_;
};

double extent(const Vector& x, int dim) {
  double largest = 0;
  for (int r = 0; r < dim; ++r) {
    const auto axis = x(Eigen::seq(r, Eigen::indexing::last, dim));
    largest = std::max(largest, axis.maxCoeff() - axis.minCoeff());
  }
  return largest;
}

// The largest t with S_i - margin I >= t I, but no more than is enough for a start well inside. Where there
// is no t above 0 the run ends here.
Vector feasible_position(const Instance& instance, const Options& options, Recorder& recorder) {
  constexpr double enough = 0.02, most = 0.1;  // eigenvalues of S are 1 at rest
  const Vector start = skinned(instance.problem);
  // All of the body moved by its extent counts as much as t = 0.01.
  const double size = extent(instance.rest, instance.dim());
  const Nearness objective(start, 0.02 / (size * size * instance.problem.node_count()));
  const ConstraintFunctions constraints(instance.problem, ConstraintForm::principal_minors, true);
  ConstrainedProgram program(instance, objective, constraints, recorder);
  program.start_at(unknowns_from(instance.problem, start, true));
  program.look_for_shift(enough, most);
  const auto [status, message] = optimize(program, options, recorder);
  if (!program.has_enough() && !(status == Status::converged && program.shift() > 0))
    recorder.end(status == Status::converged ? Status::stalled : status,
                 "in search of a feasible start, and found none: " + message);
  return program.positions();
}

// From the minimiser without constraints.
Vector run_minors(const Instance& instance, const Options& options, Recorder& recorder) {
  return optimize_energy(instance, ConstraintForm::principal_minors, skinned(instance.problem), options,
                         recorder);
}

// From a strictly feasible position, which it looks for itself: the time is one of modelling.
Vector run_feasible(const Instance& instance, const Options& options, Recorder& recorder) {
  const Vector start = feasible_position(instance, options, recorder);
  if (recorder.ended()) return start;
  return optimize_energy(instance, ConstraintForm::principal_minors, start, options, recorder);
}

// On the second-order cones of 2D.
Vector run_cone(const Instance& instance, const Options& options, Recorder& recorder) {
  if (instance.dim() != 2) {
    recorder.end(Status::not_applicable, "only matrices of two rows are second-order cones");
    return {};
  }
  return optimize_energy(instance, ConstraintForm::second_order_cone, skinned(instance.problem), options,
                         recorder);
}

}  // namespace

std::vector<Entry> ipopt_solvers() {
#if defined(ISOSTRETCH_WITH_IPOPT)
  const std::string needs;
#else
  const std::string needs = "isostretch was built without Ipopt (Debian: coinor-libipopt-dev)";
#endif
  constexpr std::string_view source = "Waechter, Biegler 2006: filter line search, interior point";
  return {{{"ipopt", "Ipopt", source, Kind::convex, needs}, run_minors},
          {{"ipopt_feasible", "Ipopt, feasible start", source, Kind::convex, needs}, run_feasible},
          {{"ipopt_cone", "Ipopt, cones", source, Kind::convex, needs}, run_cone}};
}

}  // namespace isostretch::baselines

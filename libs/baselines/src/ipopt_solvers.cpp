#include "ipopt_solvers.hpp"

#include "ipopt_nlp.hpp"
#include "unconstrained.hpp"

#include <IpIpoptApplication.hpp>

#include <algorithm>
#include <cmath>
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

std::pair<Status, std::string> outcome_of(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return {Status::converged, "optimal"};
    case Ipopt::Solved_To_Acceptable_Level:
      return {Status::converged, "optimal to Ipopt's acceptable level, not to the tolerance"};
    case Ipopt::Infeasible_Problem_Detected:
      return {Status::claims_infeasible, "converged to a point of local infeasibility"};
    case Ipopt::Search_Direction_Becomes_Too_Small:
      return {Status::stalled, "the search direction became too small"};
    case Ipopt::Diverging_Iterates:
      return {Status::stalled, "the iterates diverge"};
    case Ipopt::Restoration_Failed:
      return {Status::stalled, "the restoration phase failed"};
    case Ipopt::Error_In_Step_Computation:
      return {Status::stalled, "no step could be computed"};
    case Ipopt::Feasible_Point_Found:
      return {Status::stalled, "it found no more than a feasible point"};
    case Ipopt::Maximum_Iterations_Exceeded:
      return {Status::iteration_limit, "the largest number of iterations is reached"};
    case Ipopt::Maximum_CpuTime_Exceeded:
      return {Status::time_limit, "the time limit is reached"};
    case Ipopt::Insufficient_Memory:
      return {Status::memory_limit, "out of memory"};
    default:
      return {Status::failed, "Ipopt ended with code " + std::to_string(status)};
  }
}

Ipopt::ApplicationReturnStatus optimize(const Ipopt::SmartPtr<Ipopt::TNLP>& nlp, const Options& options,
                                        const Recorder& recorder) {
  // Without a console.
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  application->RethrowNonIpoptException(true);
  const auto& list = application->Options();
  list->SetNumericValue("tol", options.tolerance);
  // Measured: the monotone barrier of the default never ends on a stretched bar. Bounds relaxed by 1e-8, its
  // default, let eigenvalues be -1e-4 where two of an element's are small.
  list->SetStringValue("mu_strategy", "adaptive");
  list->SetNumericValue("bound_relax_factor", 0);
  list->SetStringValue("sb", "yes");
  list->SetIntegerValue("print_level", 0);
  if (options.limits.iterations > 0)  // Of both phases together.
    list->SetIntegerValue("max_iter", std::max(0, options.limits.iterations - recorder.iterations()));
  const Ipopt::ApplicationReturnStatus status = application->Initialize("");
  return status == Ipopt::Solve_Succeeded ? application->OptimizeTNLP(nlp) : status;
}

Vector optimize_energy(const Instance& instance, ConstraintForm form, const Vector& start,
                       const Options& options, Recorder& recorder) {
  const EnergyObjective objective(instance.problem);
  const ConstraintFunctions constraints(instance.problem, form);
  const Ipopt::SmartPtr<IpoptNlp> nlp = new IpoptNlp(instance, objective, constraints, recorder);
  nlp->start_at(unknowns_from(instance.problem, start, false));
  recorder.begin(Phase::solving);
  const auto [status, message] = outcome_of(optimize(Ipopt::GetRawPtr(nlp), options, recorder));
  recorder.end(status, message);
  recorder.result().iterations += nlp->iterations();
  return nlp->positions();
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
  const Ipopt::SmartPtr<IpoptNlp> nlp = new IpoptNlp(instance, objective, constraints, recorder);
  nlp->start_at(unknowns_from(instance.problem, start, true));
  nlp->look_for_shift(enough, most);
  const auto [status, message] = outcome_of(optimize(Ipopt::GetRawPtr(nlp), options, recorder));
  recorder.result().iterations += nlp->iterations();
  if (!nlp->has_enough() && !(status == Status::converged && nlp->shift() > 0))
    recorder.end(status == Status::converged ? Status::stalled : status,
                 "in search of a feasible start, and found none: " + message);
  return nlp->positions();
}

}  // namespace

Vector run_ipopt(const Instance& instance, const Options& options, Recorder& recorder) {
  return optimize_energy(instance, ConstraintForm::principal_minors, skinned(instance.problem), options,
                         recorder);
}

Vector run_ipopt_feasible(const Instance& instance, const Options& options, Recorder& recorder) {
  const Vector start = feasible_position(instance, options, recorder);
  if (recorder.ended()) return start;
  return optimize_energy(instance, ConstraintForm::principal_minors, start, options, recorder);
}

Vector run_ipopt_cone(const Instance& instance, const Options& options, Recorder& recorder) {
  if (instance.dim() != 2) {
    recorder.end(Status::not_applicable, "only matrices of two rows are second-order cones");
    return {};
  }
  return optimize_energy(instance, ConstraintForm::second_order_cone, skinned(instance.problem), options,
                         recorder);
}

}  // namespace isostretch::baselines

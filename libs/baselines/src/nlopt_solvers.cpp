#include "nlopt_solvers.hpp"

#include "constraint_functions.hpp"
#include "objective.hpp"
#include "unconstrained.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;
using Optimizer = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

// An algorithm with what it takes.
struct Algorithm {
  nlopt_algorithm code;
  const char* name;
  // NLopt ends by the change in one step, which says little about the gap: so much of the tolerance.
  double step_tolerance;
  // Elements beyond which it takes more than ten minutes, extrapolated from this: of 400 triangles MMA and
  // CCSA take ten seconds and more a step (each solves a dual problem with as many unknowns as there are
  // functions), SLSQP 0.6 s (each is the cube of the unknowns; of 144 triangles it needs 400 steps), and
  // AUGLAG takes up to 5000 evaluations of a dense Jacobian, which has 0.4 GB with 3000 tets.
  int most_elements;
};
constexpr Algorithm mma = {NLOPT_LD_MMA, "MMA", 1, 200}, ccsaq = {NLOPT_LD_CCSAQ, "CCSAQ", 1, 200},
                    slsqp = {NLOPT_LD_SLSQP, "SLSQP", 1e-3, 500},
                    auglag = {NLOPT_AUGLAG, "AUGLAG", 1e-3, 3000},
                    lbfgs = {NLOPT_LD_LBFGS, "LBFGS", 1e-3, 3000};

// minimise the energy such that -c(x) <= 0, as NLopt asks for it: all derivatives dense.
class NloptProblem {
 public:
  NloptProblem(const Instance& instance, Recorder& recorder)
      : objective_(instance.problem),
        constraints_(instance.problem, ConstraintForm::principal_minors),
        recorder_(recorder),
        jacobian_(at(constraints_.count() * constraints_.columns())) {}

  int unknowns() const { return constraints_.unknowns(); }
  int constraints() const { return constraints_.count(); }
  // Gradients so far: NLopt does not tell its iterations.
  int iterations() const { return iterations_; }
  void stop_through(nlopt_opt optimizer) { optimizer_ = optimizer; }
  // What a callback threw, which must not leave through NLopt.
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

  static double objective(unsigned n, const double* x, double* gradient, void* self) {
    return static_cast<NloptProblem*>(self)->guarded([&](NloptProblem& problem) {
      const Vector positions = Eigen::Map<const Vector>(x, n);
      if (gradient) problem.show(positions, {gradient, n});
      return problem.objective_.value(positions);
    });
  }

  static void inequalities(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                           void* self) {
    static_cast<NloptProblem*>(self)->guarded([&](NloptProblem& problem) {
      problem.constraints_.values({x, n}, {result, m});
      for (unsigned k = 0; k < m; ++k) result[k] = -result[k];
      if (gradient) problem.dense_jacobian({x, n}, {gradient, std::size_t{m} * n});
      return 0.0;
    });
  }

 private:
  double guarded(const auto& evaluate) {
    try {
      return evaluate(*this);
    } catch (...) {
      error_ = std::current_exception();
      nlopt_force_stop(optimizer_);
      return 0;
    }
  }

  void show(const Vector& x, std::span<double> gradient) {
    objective_.gradient(x, gradient);
    if (!recorder_.record(x, iterations_++)) nlopt_force_stop(optimizer_);
  }

  void dense_jacobian(std::span<const double> x, std::span<double> rows) {
    constraints_.jacobian(x, jacobian_);
    std::fill(rows.begin(), rows.end(), 0.0);
    std::size_t place = 0;
    for (int row = 0; row < constraints_.count(); ++row)
      for (int column = 0; column < constraints_.columns(); ++column)
        rows[at(row) * x.size() + at(constraints_.unknown(row / constraints_.per_element(), column))] =
            -jacobian_[place++];
  }

  EnergyObjective objective_;
  ConstraintFunctions constraints_;
  Recorder& recorder_;
  std::vector<double> jacobian_;
  nlopt_opt optimizer_ = nullptr;
  int iterations_ = 0;
  std::exception_ptr error_;
};

std::pair<Status, std::string> outcome_of(nlopt_result code, nlopt_opt optimizer) {
  switch (code) {
    case NLOPT_SUCCESS:
    case NLOPT_STOPVAL_REACHED:
    case NLOPT_FTOL_REACHED:
    case NLOPT_XTOL_REACHED:
      return {Status::converged, nlopt_result_to_string(code)};
    case NLOPT_MAXEVAL_REACHED:
      return {Status::iteration_limit, "the largest number of evaluations is reached"};
    case NLOPT_MAXTIME_REACHED:
      return {Status::time_limit, "the time limit is reached"};
    case NLOPT_OUT_OF_MEMORY:
      return {Status::memory_limit, "out of memory"};
    case NLOPT_ROUNDOFF_LIMITED:
      return {Status::stalled, "no progress for rounding"};
    default: {
      const char* said = nlopt_get_errmsg(optimizer);
      return {Status::failed,
              std::string(nlopt_result_to_string(code)) + (said ? ": " : "") + (said ? said : "")};
    }
  }
}

Optimizer make_optimizer(const Algorithm& algorithm, const NloptProblem& problem, const Options& options) {
  Optimizer optimizer(nlopt_create(algorithm.code, static_cast<unsigned>(problem.unknowns())), nlopt_destroy);
  if (!optimizer) throw std::bad_alloc();
  nlopt_set_ftol_rel(optimizer.get(), algorithm.step_tolerance * options.tolerance);
  // Of the dual problems in MMA and CCSA. By default 1e-14: measured, twenty times slower for no gain.
  nlopt_set_param(optimizer.get(), "dual_ftol_rel", 0.01 * options.tolerance);
  return optimizer;
}

// Hard targets are bounds that meet; NLopt takes such entries out.
void hold_hard_targets(const sdp_penalty::Problem& problem, nlopt_opt optimizer) {
  const int dim = problem.dim();
  for (const sdp_penalty::Target& target : problem.targets)
    for (int r = 0; target.hard && r < dim; ++r) {
      nlopt_set_lower_bound(optimizer, target.node * dim + r, target.position[at(r)]);
      nlopt_set_upper_bound(optimizer, target.node * dim + r, target.position[at(r)]);
    }
}

void set_limits(const Options& options, nlopt_opt optimizer) {
  if (options.limits.iterations > 0) nlopt_set_maxeval(optimizer, options.limits.iterations);
  // NLopt takes 0 for no limit, and the deadline may have passed.
  constexpr double shortest = 1e-9;
  if (const double left = options.stop.seconds_left(); std::isfinite(left))
    nlopt_set_maxtime(optimizer, std::max(left, shortest));
}

// Of the minors, whose gradients are about 1 at rest.
constexpr double constraint_tolerance = 1e-8;

Vector optimize(const Algorithm& algorithm, const Instance& instance, const Options& options,
                Recorder& recorder) {
  if (const int elements = instance.problem.element_count(); elements > algorithm.most_elements) {
    recorder.end(Status::not_applicable, std::to_string(elements) + " elements are too many for " +
                                             algorithm.name + ", whose matrices are dense: beyond " +
                                             std::to_string(algorithm.most_elements) +
                                             " it takes more than ten minutes");
    return {};
  }
  Vector x = skinned(instance.problem);
  NloptProblem problem(instance, recorder);
  const Optimizer optimizer = make_optimizer(algorithm, problem, options);
  problem.stop_through(optimizer.get());
  nlopt_set_min_objective(optimizer.get(), NloptProblem::objective, &problem);
  const std::vector<double> tolerances(at(problem.constraints()), constraint_tolerance);
  nlopt_add_inequality_mconstraint(optimizer.get(), static_cast<unsigned>(tolerances.size()),
                                   NloptProblem::inequalities, &problem, tolerances.data());
  hold_hard_targets(instance.problem, optimizer.get());
  if (algorithm.code == NLOPT_AUGLAG)
    nlopt_set_local_optimizer(optimizer.get(), make_optimizer(lbfgs, problem, options).get());
  recorder.begin(Phase::solving);
  set_limits(options, optimizer.get());
  double energy = 0;
  const nlopt_result code = nlopt_optimize(optimizer.get(), x.data(), &energy);
  problem.rethrow();
  const auto [status, message] = outcome_of(code, optimizer.get());
  recorder.end(status, message);
  recorder.result().iterations = problem.iterations();
  return x;
}

}  // namespace

Vector run_nlopt_mma(const Instance& instance, const Options& options, Recorder& recorder) {
  return optimize(mma, instance, options, recorder);
}

Vector run_nlopt_ccsaq(const Instance& instance, const Options& options, Recorder& recorder) {
  return optimize(ccsaq, instance, options, recorder);
}

Vector run_nlopt_slsqp(const Instance& instance, const Options& options, Recorder& recorder) {
  return optimize(slsqp, instance, options, recorder);
}

Vector run_nlopt_auglag(const Instance& instance, const Options& options, Recorder& recorder) {
  return optimize(auglag, instance, options, recorder);
}

}  // namespace isostretch::baselines

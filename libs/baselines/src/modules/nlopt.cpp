// NLopt (Johnson) as a module of its own, which nothing but the program's interface ties to the library.
#include "nonlinear_program.hpp"

#include <isostretch/core/index.hpp>

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::baselines {
namespace {

using Optimizer = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

// minimise f such that -c(x) <= 0, as NLopt asks for it: all derivatives dense. Gradients are counted as
// iterations, which NLopt does not tell.
class DenseProgram {
 public:
  explicit DenseProgram(NonlinearProgram& program)
      : program_(program),
        sizes_(program.sizes()),
        rows_(at(sizes_.jacobian_entries)),
        columns_(rows_.size()),
        entries_(rows_.size()) {
    program.jacobian_structure(rows_, columns_);
  }

  int unknowns() const { return sizes_.unknowns; }
  int constraints() const { return sizes_.constraints; }
  void stop_through(nlopt_opt optimizer) { optimizer_ = optimizer; }
  // What a callback threw, which must not leave through NLopt.
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

  static double objective(unsigned n, const double* x, double* gradient, void* self) {
    return static_cast<DenseProgram*>(self)->guarded([&](DenseProgram& dense) {
      if (gradient) dense.show({x, n}, {gradient, n});
      return dense.program_.value({x, n});
    });
  }

  static void inequalities(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                           void* self) {
    static_cast<DenseProgram*>(self)->guarded([&](DenseProgram& dense) {
      dense.program_.constraints({x, n}, {result, m});
      for (unsigned k = 0; k < m; ++k) result[k] = -result[k];
      if (gradient) dense.jacobian({x, n}, {gradient, std::size_t{m} * n});
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

  void show(std::span<const double> x, std::span<double> gradient) {
    program_.gradient(x, gradient);
    if (!program_.take_iterate(iterations_++, x)) nlopt_force_stop(optimizer_);
  }

  void jacobian(std::span<const double> x, std::span<double> dense) {
    program_.jacobian(x, entries_);
    std::fill(dense.begin(), dense.end(), 0.0);
    for (std::size_t i = 0; i < entries_.size(); ++i)
      dense[at(rows_[i]) * x.size() + at(columns_[i])] = -entries_[i];
  }

  NonlinearProgram& program_;
  NonlinearProgram::Sizes sizes_;
  std::vector<int> rows_, columns_;
  std::vector<double> entries_;
  nlopt_opt optimizer_ = nullptr;
  int iterations_ = 0;
  std::exception_ptr error_;
};

ProgramOutcome outcome_of(nlopt_result code, nlopt_opt optimizer) {
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

nlopt_algorithm algorithm_named(std::string_view name) {
  if (name == "MMA") return NLOPT_LD_MMA;
  if (name == "CCSAQ") return NLOPT_LD_CCSAQ;
  return name == "SLSQP" ? NLOPT_LD_SLSQP : NLOPT_AUGLAG;
}

Optimizer make_optimizer(nlopt_algorithm algorithm, int unknowns, const ProgramOptions& options) {
  Optimizer optimizer(nlopt_create(algorithm, static_cast<unsigned>(unknowns)), nlopt_destroy);
  if (!optimizer) throw std::bad_alloc();
  nlopt_set_ftol_rel(optimizer.get(), options.step_tolerance);
  // Of the dual problems in MMA and CCSA. By default 1e-14: measured, twenty times slower for no gain.
  nlopt_set_param(optimizer.get(), "dual_ftol_rel", 0.01 * options.tolerance);
  return optimizer;
}

// NLopt takes entries out whose bounds meet.
void set_bounds(const NonlinearProgram& program, nlopt_opt optimizer) {
  std::vector<double> lower(at(program.sizes().unknowns)), upper(lower.size());
  program.bounds(lower, upper);
  nlopt_set_lower_bounds(optimizer, lower.data());
  nlopt_set_upper_bounds(optimizer, upper.data());
}

void set_limits(const ProgramOptions& options, nlopt_opt optimizer) {
  if (options.iterations > 0) nlopt_set_maxeval(optimizer, options.iterations);
  // NLopt takes 0 for no limit, and the deadline may have passed.
  constexpr double shortest = 1e-9;
  if (std::isfinite(options.seconds)) nlopt_set_maxtime(optimizer, std::max(options.seconds, shortest));
}

// Of the minors, whose gradients are about 1 at rest.
constexpr double constraint_tolerance = 1e-8;

}  // namespace

extern "C" void isostretch_solve_by_nlopt(NonlinearProgram& program, const ProgramOptions& options,
                                          ProgramOutcome& outcome);
extern "C" void isostretch_solve_by_nlopt(NonlinearProgram& program, const ProgramOptions& options,
                                          ProgramOutcome& outcome) {
  const nlopt_algorithm algorithm = algorithm_named(options.algorithm);
  DenseProgram dense(program);
  const Optimizer optimizer = make_optimizer(algorithm, dense.unknowns(), options);
  dense.stop_through(optimizer.get());
  nlopt_set_min_objective(optimizer.get(), DenseProgram::objective, &dense);
  const std::vector<double> tolerances(at(dense.constraints()), constraint_tolerance);
  nlopt_add_inequality_mconstraint(optimizer.get(), static_cast<unsigned>(tolerances.size()),
                                   DenseProgram::inequalities, &dense, tolerances.data());
  set_bounds(program, optimizer.get());
  if (algorithm == NLOPT_AUGLAG)
    nlopt_set_local_optimizer(optimizer.get(),
                              make_optimizer(NLOPT_LD_LBFGS, dense.unknowns(), options).get());
  set_limits(options, optimizer.get());
  std::vector<double> x(at(dense.unknowns()));
  program.start(x);
  double value = 0;
  const nlopt_result code = nlopt_optimize(optimizer.get(), x.data(), &value);
  dense.rethrow();
  program.finish(x);
  outcome = outcome_of(code, optimizer.get());
}

}  // namespace isostretch::baselines

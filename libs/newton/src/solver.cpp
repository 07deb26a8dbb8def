#include "hessian_policy.hpp"
#include "newton_system.hpp"
#include "scaled_gradient_test.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/newton/line_search.hpp>
#include <isostretch/newton/minimization_driver.hpp>
#include <isostretch/newton/minimize.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace isostretch::newton {
namespace {

// On the line from the exact Hessian (0) by clamping (1/2) to absolute values (1).
double projection_weight_of(const projection::FilterOptions& filter) {
  if (filter.filter == projection::Filter::none) return 0.0;
  if (filter.filter == projection::Filter::clamp) return 0.5 * filter.weight;
  return filter.filter == projection::Filter::bounded_abs ? 0.5 + 0.5 * filter.weight : filter.weight;
}

}  // namespace

// What one solve leaves for the next.
struct Solver::Workspace {
  Options options;
  NewtonSystem system;
};

// One solve, from start to summary.
class Solver::Solve {
 public:
  Solve(Workspace& kept, Vector x, const IterationCallback& callback)
      : objective_(kept.system.objective()),
        options_(kept.options),
        system_(kept.system),
        driver_(summary_, options_, callback),
        scales_(options_, system_, summary_),
        policy_(options_, objective_.has_barrier()),
        x_(std::move(x)) {}

  // Both return whether there is a step to come.
  bool start() { return (set_up() && !stop_before_step()) || finish(); }
  bool step() {
    if (objective_.version() != version_)
      throw Error("newton: terms, pins or equality constraints were added to the objective during a solve");
    return (take_step() && !stop_before_step()) || finish();
  }

  bool ended() const { return driver_.ended(); }
  const Vector& positions() const { return x_; }
  const Summary& summary() const { return summary_; }
  Vector take_positions() { return std::move(x_); }
  Summary take_summary() { return std::move(summary_); }

 private:
  bool set_up() {
    if (!driver_.begin(x_)) return false;
    {
      const ScopedTimer timer(summary_.seconds.setup);
      version_ = objective_.version();
      objective_.begin_solve(x_);
      system_.prepare(x_, options_.solver);
    }
    log(LogLevel::debug, [&] {
      return "newton: " + std::to_string(system_.size()) + " unknowns, " +
             std::to_string(system_.nonzeros()) + " entries in the Hessian, pattern and analysis in " +
             to_text(summary_.seconds.setup) + " s";
    });
    filter_ = policy_.first();
    const Evaluation at = differentiate();
    if (!driver_.begin(at)) return false;
    if (!derivatives_fault_.empty())
      return driver_.end(Status::failed_start, derivatives_fault_ + " at the start");
    return record({}, at.value);
  }

  // Energy, gradient and the Hessian as filter_ wants it, at x_.
  Evaluation differentiate() {
    {
      const ScopedTimer timer(summary_.seconds.setup);
      system_.follow_stencils();
    }
    const ScopedTimer timer(summary_.seconds.assembly);
    if (policy_.by_residual()) {
      objective_.differentiate(x_, filter_, gradient_, false);
      policy_.choose_nodes(gradient_, objective_.dim(), filter_);
    }
    const Evaluation at = objective_.differentiate(x_, filter_, gradient_, true);
    objective_.restrict(gradient_, reduced_);
    points_filtered_ = at.points_filtered;
    derivatives_fault_.clear();
    if (std::isfinite(at.value)) assemble();
    return at;
  }

  // Infinity and NaN end here, where the element can still be named, and not in the solver.
  void assemble() {
    const bool gradient = gradient_.allFinite(), hessian = system_.assemble();
    if (gradient && hessian) return;
    derivatives_fault_ = std::string(gradient ? "the Hessian" : "the gradient") + " is not finite";
    if (const int element = objective_.element_not_finite(); element >= 0)
      derivatives_fault_ += " in element " + std::to_string(element);
  }

  bool end_at_fault() { return driver_.end(Status::failed_derivatives, derivatives_fault_); }

  bool record(const Iteration& row, double energy) {
    const bool goes_on = driver_.record(row, x_, energy, reduced_);
    log(LogLevel::trace, [&] {
      return "newton: iteration " + std::to_string(summary_.iterations) + ": energy " + to_text(energy) +
             ", |gradient|_inf " + to_text(summary_.gradient_inf_norm) + ", step " + to_text(row.step);
    });
    return goes_on;
  }

  bool stop_before_step() {
    if (driver_.ended() || !driver_.go_on_with_gradient(system_.size())) return true;
    if (scales_.passes(x_)) return !end_scaled();
    return !(driver_.go_on_with_slope() && driver_.go_on_within_limits());
  }

  bool end_scaled() {
    return driver_.end(Status::converged_scaled_gradient,
                       "|gradient|_inf is within scaled_gradient_tolerance");
  }

  // Factorises the Hessian at x_, filtering more or shifting until it succeeds.
  bool factorize(Iteration& row) {
    const auto stiffness = [&] { return system_.typical_stiffness(); };
    double shift = std::max(options_.relative_shift, 0.1 * last_relative_shift_) * stiffness();
    for (int shifts = 0;;) {
      const sparse::FactorResult result = factorize_shifted(shift);
      ++row.factorizations;
      ++summary_.factorizations;
      if (result) {
        last_relative_shift_ = shift / stiffness();
        scales_.set_exact_model(points_filtered_ == 0 && shift <= options_.relative_shift * stiffness());
        return true;
      }
      ++summary_.failed_factorizations;
      if (result.status != sparse::FactorStatus::not_positive_definite)
        return driver_.end(Status::failed_factorization, result.message);
      if (policy_.stronger(filter_)) {
        if (!filter_again(row)) return false;
        continue;
      }
      if (++shifts > options_.max_shifts)
        return driver_.end(
            Status::failed_factorization,
            stiffness() > 0
                ? "the Hessian is not positive definite with a diagonal shift of " + to_text(shift)
                : "the Hessian is zero where it is not negative: no step can be told from it");
      shift = std::max(100 * shift, 1e-12 * stiffness());
      log(LogLevel::debug, [&] {
        return "newton: iteration " + std::to_string(row.iteration) +
               ": the Hessian does not factorise although it is filtered; its diagonal is shifted by " +
               to_text(shift);
      });
    }
  }

  sparse::FactorResult factorize_shifted(double shift) {
    const ScopedTimer timer(summary_.seconds.factorization);
    return system_.factorize(x_, shift);
  }

  bool filter_again(const Iteration& row) {
    log(LogLevel::debug, [&] {
      return "newton: iteration " + std::to_string(row.iteration) +
             ": the Hessian is not positive definite; filtered again with weight " +
             to_text(projection_weight_of(filter_));
    });
    differentiate();
    return derivatives_fault_.empty() || end_at_fault();
  }

  // Relative residual for the next solve.
  void force() {
    if (options_.largest_forcing == 0) return;
    constexpr double factor = 0.9, confirming = 1e-3;
    const double norm = reduced_.norm(), ratio = norm / forced_norm_;
    double forcing = options_.largest_forcing;
    if (forced_norm_ > 0) forcing = std::min(forcing, factor * ratio * ratio);
    // What the step promises decides whether it is the end: it must not be underestimated.
    if (scales_.awaits_decrement() || options_.decrement_tolerance > 0)
      forcing = std::min(forcing, confirming);
    forced_norm_ = norm;
    system_.set_tolerance(std::max(forcing, options_.solver.pcg_tolerance));
  }

  // Newton direction over all degrees of freedom. An iterative solver notices only here that the matrix is
  // indefinite, and gets a stronger filter as a failed factorization does; where there is none left, what it
  // had found by then descends.
  bool solve(Iteration& row) {
    Vector right = -reduced_, solution;
    force();
    for (;;) {
      sparse::SolveResult result;
      {
        const ScopedTimer timer(summary_.seconds.solve);
        result = system_.solve(right, solution);
      }
      solved_ = static_cast<bool>(result);
      if (result || result.status == sparse::SolveStatus::not_converged) break;
      ++summary_.failed_factorizations;
      const bool indefinite = result.status == sparse::SolveStatus::not_positive_definite;
      if (!indefinite || !policy_.stronger(filter_)) {
        if (indefinite && right.dot(solution) > 0) break;
        return driver_.end(Status::failed_factorization, result.message);
      }
      if (!filter_again(row) || !factorize(row)) return false;
    }
    objective_.extend(solution, direction_);
    return true;
  }

  bool take_step() {
    Iteration row;
    row.iteration = summary_.iterations + 1;
    if (!factorize(row) || !solve(row)) return false;
    const double slope = gradient_.dot(direction_);
    row.decrement = -0.5 * slope;
    row.projection_weight = projection_weight_of(filter_);
    row.points_filtered = points_filtered_;
    if (!(slope < 0)) return driver_.end(Status::failed_line_search, "the Newton direction does not descend");
    if (solved_ && scales_.passes_with(row.decrement, x_)) return end_scaled();
    if (options_.decrement_tolerance > 0 && solved_ && row.decrement <= options_.decrement_tolerance)
      return driver_.end(Status::converged_decrement, "the Newton decrement is within decrement_tolerance");
    const LineSearchResult search = search_from_here(slope);
    if (!search.accepted)
      return search.at_roundoff
                 ? driver_.end(Status::converged_roundoff, "no step lowers the energy beyond its rounding")
                 : driver_.end(Status::failed_line_search, "no step along the direction lowers the energy");
    return accept(row, search);
  }

  LineSearchResult search_from_here(double slope) {
    const ScopedTimer timer(summary_.seconds.line_search);
    const LineSearchResult search = search_line(objective_, x_, direction_, summary_.energy, slope,
                                                scales_.energy_noise(x_), options_, trial_);
    summary_.energy_evaluations += search.evaluations;
    return search;
  }

  bool accept(Iteration& row, const LineSearchResult& search) {
    const double before = summary_.energy, gradient_before = summary_.gradient_inf_norm;
    policy_.step_taken(search.step, search.model_fit);
    scales_.step_taken(row.decrement, solved_ && search.step > 0.5 && search.step <= 1);
    filter_ = policy_.first();
    previous_.swap(x_);
    x_.swap(trial_);
    objective_.accepted(x_);
    const Evaluation at = differentiate();
    if (!std::isfinite(at.value)) {
      x_.swap(previous_);
      return driver_.end(Status::failed_line_search, "the energy is not finite after a step that was");
    }
    ++summary_.iterations;
    row.step = search.step;
    row.model_fit = search.model_fit;
    row.evaluations = search.evaluations;
    if (!record(row, at.value)) return false;
    if (!derivatives_fault_.empty()) return end_at_fault();
    // Where energies are equal to rounding only the gradient can tell progress from a random walk.
    if (search.at_roundoff && summary_.gradient_inf_norm > 0.5 * gradient_before)
      return driver_.end(Status::converged_roundoff,
                         "no step lowers energy or gradient beyond their rounding");
    const double gain = objective_.has_exact_changes() ? -search.change : before - at.value;
    if (options_.relative_energy_tolerance > 0 && search.step >= 1.0 &&
        gain <= options_.relative_energy_tolerance * std::abs(at.value))
      return driver_.end(Status::converged_energy, "the energy changes less than relative_energy_tolerance");
    return true;
  }

  // Returns false, as there is no step to come.
  bool finish() {
    driver_.finish(system_.solver());
    log(LogLevel::debug,
        [&] { return "newton: " + summary_.brief_report() + ", solved with " + summary_.solver; });
    return false;
  }

  Objective& objective_;
  const Options& options_;
  NewtonSystem& system_;
  Summary summary_;
  MinimizationDriver driver_;
  ScaledGradientTest scales_;
  HessianPolicy policy_;
  int version_ = 0;  // of the objective, at the start
  projection::FilterOptions filter_;
  Vector x_;
  Vector gradient_, reduced_, direction_, trial_, previous_;
  double forced_norm_ = 0;  // |gradient| at the last inexact solve
  bool solved_ = false;     // the last linear system, as accurately as wanted: its decrement can be trusted
  double last_relative_shift_ = 0;
  std::size_t points_filtered_ = 0;
  std::string derivatives_fault_;  // why derivatives at x_ cannot be used; empty: they can
};

Solver::Solver(Objective& objective, const Options& options, std::unique_ptr<sparse::Solver> linear_solver)
    : workspace_(new Workspace{options, NewtonSystem(objective, std::move(linear_solver))}) {
  options.validate();
}

Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

void Solver::require_startable(const Vector& x) const {
  const Objective& objective = workspace_->system.objective();
  if (x.size() != objective.dofs())
    throw Error("start of " + std::to_string(x.size()) + " entries for " + std::to_string(objective.dofs()) +
                " degrees of freedom");
  if (!objective.has_terms()) throw Error("the objective has no terms: there is nothing to minimize");
  objective.require_equalities(x);
}

Summary Solver::solve(Vector& x, const IterationCallback& callback) {
  require_startable(x);
  current_.reset();
  Solve solve(*workspace_, std::move(x), callback);
  struct GiveBack {
    Solve& solve;
    Vector& x;
    ~GiveBack() { x = solve.take_positions(); }  // also when a callback or a term throws
  } const give_back{solve, x};
  if (solve.start())
    while (solve.step()) continue;
  return solve.take_summary();
}

bool Solver::start(Vector x) {
  require_startable(x);
  current_ = std::make_unique<Solve>(*workspace_, std::move(x), IterationCallback());
  return current_->start();
}

bool Solver::step() {
  if (!current_) throw Error("newton: step() before start()");
  return !current_->ended() && current_->step();
}

const Vector& Solver::positions() const {
  if (!current_) throw Error("newton: positions() before start()");
  return current_->positions();
}

const Summary& Solver::summary() const {
  if (!current_) throw Error("newton: summary() before start()");
  return current_->summary();
}

void Solver::set_options(const Options& options) {
  options.validate();
  current_.reset();
  if (options.solver != workspace_->options.solver) workspace_->system.drop_solver();
  workspace_->options = options;
}

const Options& Solver::options() const {
  return workspace_->options;
}

int Solver::analyses() const {
  return workspace_->system.analyses();
}

Summary minimize(Objective& objective, Vector& x, const Options& options, const IterationCallback& callback) {
  return Solver(objective, options).solve(x, callback);
}

}  // namespace isostretch::newton

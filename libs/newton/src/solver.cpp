#include "hessian_policy.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/newton/line_search.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/newton/positions.hpp>
#include <isostretch/sparse/solver.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::newton {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// On the line from the exact Hessian (0) by clamping (1/2) to absolute values (1).
double strength_of(const projection::FilterOptions& filter) {
  if (filter.filter == projection::Filter::none) return 0.0;
  if (filter.filter == projection::Filter::clamp) return 0.5 * filter.strength;
  return filter.filter == projection::Filter::bounded_abs ? 0.5 + 0.5 * filter.strength : filter.strength;
}

}  // namespace

// What one solve leaves for the next.
struct Solver::Kept {
  Objective* objective = nullptr;
  Options options;
  std::unique_ptr<sparse::Solver> linear;
  bool handed_in = false;
  int analyzed_version = -1;  // of the objective
  int analyses = 0;
  sparse::SymmetricMatrix matrix;
  std::vector<int> axes;  // of the unknowns

  bool has_analysis() const {
    return linear && analyzed_version == objective->version() &&
           linear->statistics().backend != sparse::Backend::pcg;
  }
};

// One solve, from start to summary.
class Solver::Solve {
 public:
  Solve(Kept& kept, Vector x, IterationCallback callback)
      : kept_(kept),
        objective_(*kept.objective),
        options_(kept.options),
        matrix_(kept.matrix),
        x_(std::move(x)),
        callback_(std::move(callback)),
        policy_(options_, objective_.has_barrier()) {}

  // Both return whether there is a step to come.
  bool start() { return (set_up() && !stop_before_step()) || finish(); }
  bool step() {
    if (objective_.version() != version_)
      throw Error("newton: terms, pins or ties were added to the objective during a solve");
    return (take_step() && !stop_before_step()) || finish();
  }

  bool ended() const { return summary_.status != Status::not_run; }
  const Vector& positions() const { return x_; }
  const Summary& summary() const { return summary_; }
  Vector take_positions() { return std::move(x_); }
  Summary take_summary() { return std::move(summary_); }

 private:
  bool set_up() {
    if (!x_.allFinite()) return end(Status::failed_start, "the start has positions that are not finite");
    {
      const ScopedTimer timer(summary_.seconds.setup);
      version_ = objective_.version();
      if (kept_.has_analysis())
        tell_positions();
      else
        analyze();
    }
    log(LogLevel::debug, [&] {
      return "newton: " + std::to_string(matrix_.size) + " unknowns, " +
             std::to_string(matrix_.value.size()) + " entries in the Hessian, pattern and analysis in " +
             to_text(summary_.seconds.setup) + " s";
    });
    filter_ = policy_.first();
    objective_.begin_solve(x_);
    const Evaluation at = differentiate();
    summary_.initial_energy = summary_.energy = at.value;
    if (!std::isfinite(at.value))
      return end(Status::failed_start,
                 "the energy is not finite at the start" +
                     (at.worst_element >= 0 ? ": first at element " + std::to_string(at.worst_element)
                                            : std::string()));
    if (!derivatives_fault_.empty()) return end(Status::failed_start, derivatives_fault_ + " at the start");
    Iteration row;
    row.energy = at.value;
    return record(row);
  }

  void analyze() {
    kept_.analyzed_version = -1;
    matrix_ = objective_.zero_matrix();
    if (matrix_.size == 0) return;
    if (!kept_.linear) kept_.linear = sparse::make_solver(options_.solver);
    kept_.axes = objective_.axes();
    tell_positions();
    if (kept_.linear->analyze(matrix_)) kept_.analyzed_version = version_;
    ++kept_.analyses;
  }

  void tell_positions() {
    kept_.linear->set_coordinates(x_.data(), objective_.dim(), objective_.node_count(), kept_.axes);
  }

  // Energy, gradient and the Hessian as filter_ wants it, at x_.
  Evaluation differentiate() {
    const ScopedTimer timer(summary_.seconds.assembly);
    if (policy_.by_residual()) {
      objective_.differentiate(x_, filter_, gradient_, false);
      policy_.choose_nodes(gradient_, objective_.dim(), filter_);
    }
    const Evaluation at = objective_.differentiate(x_, filter_, gradient_, true);
    objective_.restrict(gradient_, reduced_);
    points_filtered_ = at.points_filtered;
    derivatives_fault_.clear();
    if (std::isfinite(at.value)) {
      objective_.hessian(matrix_);
      find_fault();
      measure_stiffness();
    }
    return at;
  }

  // Infinity and NaN end here, where the element can still be named, and not in the solver.
  void find_fault() {
    const bool gradient = gradient_.allFinite();
    if (gradient && matrix_.is_finite()) return;
    derivatives_fault_ = std::string(gradient ? "the Hessian" : "the gradient") + " is not finite";
    if (const int element = objective_.element_not_finite(); element >= 0)
      derivatives_fault_ += " in element " + std::to_string(element);
  }

  bool end_at_fault() { return end(Status::failed_derivatives, derivatives_fault_); }

  // Median of the diagonal, from at most a few thousand entries spread evenly.
  void measure_stiffness() {
    constexpr int samples = 4096;
    const int stride = 1 + matrix_.size / samples;
    std::vector<double> diagonal;
    for (int j = 0; j < matrix_.size; j += stride) diagonal.push_back(std::abs(diagonal_entry(j)));
    typical_stiffness_ = median(std::move(diagonal));
  }

  double& diagonal_entry(int j) {
    return matrix_.value[static_cast<std::size_t>(matrix_.column_start[static_cast<std::size_t>(j)])];
  }

  bool record(Iteration row) {
    row.seconds = timer_.seconds();
    row.gradient_inf_norm = summary_.gradient_inf_norm =
        reduced_.size() ? reduced_.cwiseAbs().maxCoeff() : 0.0;
    summary_.trace.push_back(row);
    log(LogLevel::trace, [&] {
      return "newton: iteration " + std::to_string(row.iteration) + ": energy " + to_text(row.energy) +
             ", |gradient|_inf " + to_text(row.gradient_inf_norm) + ", step " + to_text(row.step);
    });
    if (callback_ && callback_(row, x_) == CallbackAction::stop)
      return end(Status::stopped_by_callback, "stopped by the callback");
    if (options_.stop.stop_requested()) return end(Status::stopped_by_callback, "interrupted");
    return true;
  }

  bool stop_before_step() {
    if (summary_.status != Status::not_run) return true;
    const double norm = summary_.gradient_inf_norm;
    if (matrix_.size == 0) return !end(Status::converged_gradient, "every degree of freedom is pinned");
    if (options_.gradient_tolerance > 0 && norm <= options_.gradient_tolerance)
      return !end(Status::converged_gradient, "|gradient|_inf is within gradient_tolerance");
    const double scale = typical_stiffness_ * bounding_box_diagonal(x_, objective_.dim());
    confirm_scaled_ =
        options_.scaled_gradient_tolerance > 0 && norm <= options_.scaled_gradient_tolerance * scale;
    if (confirm_scaled_ && promises_little(last_decrement_)) return !end_scaled();
    if (norm == 0) return !end(Status::converged_gradient, "the gradient is zero");
    if (summary_.iterations >= options_.max_iterations)
      return !end(Status::stopped_iterations, "the limit of iterations is reached");
    if ((options_.time_limit > 0 && timer_.seconds() >= options_.time_limit) ||
        options_.stop.deadline_passed())
      return !end(Status::stopped_time, "the limit of time is reached");
    return false;
  }

  // One median stiffness says little where elements differ by many orders of magnitude: a gradient small
  // beside it must not promise a gain of energy either. A filtered or shifted Hessian promises less than
  // there is.
  bool promises_little(double decrement) const {
    constexpr double share = 1e-8, share_if_filtered = 1e-12, negligible = 1e-12;
    return decrement <=
           (exact_model_ ? share : share_if_filtered) *
                   std::max(std::abs(summary_.energy), negligible * std::abs(summary_.initial_energy)) +
               rounding_of_positions();
  }

  // Differences of energies below this mean nothing: the rounding of a sum of many terms, a few units of
  // relative precision and never the worst case; and at rest, where the energy vanishes, of the positions.
  double energy_noise() const {
    constexpr double relative = 2e-14;
    return std::max(relative * std::abs(summary_.energy), rounding_of_positions());
  }

  // Energy of moving every node to and fro in its last digits.
  double rounding_of_positions() const {
    const double length = rounding_length(x_, objective_.dim());
    return matrix_.size * typical_stiffness_ * length * length;
  }

  bool end_scaled() {
    return end(Status::converged_scaled_gradient, "|gradient|_inf is within scaled_gradient_tolerance");
  }

  // Factorises the Hessian at x_, filtering more or shifting until it succeeds.
  bool factorize(Iteration& row) {
    double shift = std::max(options_.relative_shift, 0.1 * last_relative_shift_) * typical_stiffness_;
    for (int shifts = 0;;) {
      sparse::FactorResult result;
      {
        const ScopedTimer timer(summary_.seconds.factorization);
        if (shift > 0)
          for (int j = 0; j < matrix_.size; ++j) diagonal_entry(j) += shift;
        tell_positions();
        result = kept_.linear->factorize(matrix_);
      }
      ++row.factorizations;
      ++summary_.factorizations;
      if (result) {
        last_relative_shift_ = shift / typical_stiffness_;
        exact_model_ = points_filtered_ == 0 && shift <= options_.relative_shift * typical_stiffness_;
        return true;
      }
      ++summary_.failed_factorizations;
      if (result.status != sparse::FactorStatus::not_positive_definite)
        return end(Status::failed_factorization, result.message);
      if (policy_.stronger(filter_)) {
        log_filter(row);
        differentiate();
        if (!derivatives_fault_.empty()) return end_at_fault();
        continue;
      }
      if (++shifts > options_.max_shifts)
        return end(Status::failed_factorization,
                   typical_stiffness_ > 0
                       ? "the Hessian is not positive definite with a diagonal shift of " + to_text(shift)
                       : "the Hessian is zero where it is not negative: no step can be told from it");
      shift = std::max(100 * shift, 1e-12 * typical_stiffness_);
      log(LogLevel::debug, [&] {
        return "newton: iteration " + std::to_string(row.iteration) +
               ": the Hessian does not factorise although it is filtered; its diagonal is shifted by " +
               to_text(shift);
      });
    }
  }

  void log_filter(const Iteration& row) const {
    log(LogLevel::debug, [&] {
      return "newton: iteration " + std::to_string(row.iteration) +
             ": the Hessian is not positive definite; filtered again with strength " +
             to_text(strength_of(filter_));
    });
  }

  // Relative residual for the next solve.
  void force() {
    if (options_.largest_forcing == 0) return;
    constexpr double factor = 0.9, confirming = 1e-3;
    const double norm = reduced_.norm(), ratio = norm / forced_norm_;
    double forcing = options_.largest_forcing;
    if (forced_norm_ > 0) forcing = std::min(forcing, factor * ratio * ratio);
    // What the step promises decides whether it is the end: it must not be underestimated.
    if (confirm_scaled_ || options_.decrement_tolerance > 0) forcing = std::min(forcing, confirming);
    forced_norm_ = norm;
    kept_.linear->set_tolerance(std::max(forcing, options_.solver.pcg_tolerance));
  }

  // Newton direction over all degrees of freedom. An iterative solver notices only here that the matrix is
  // indefinite, and gets a stronger filter as a failed factorization does; where there is none left, what it
  // had found by then descends.
  bool solve(Iteration& row) {
    Vector right = -reduced_, solution(reduced_.size());
    force();
    for (;;) {
      sparse::SolveResult result;
      {
        const ScopedTimer timer(summary_.seconds.solve);
        result = kept_.linear->solve_columns(right.data(), solution.data(), 1);
      }
      solved_ = static_cast<bool>(result);
      if (result || result.status == sparse::SolveStatus::not_converged) break;
      ++summary_.failed_factorizations;
      const bool indefinite = result.status == sparse::SolveStatus::not_positive_definite;
      if (!indefinite || !policy_.stronger(filter_)) {
        if (indefinite && right.dot(solution) > 0) break;
        return end(Status::failed_factorization, result.message);
      }
      log_filter(row);
      differentiate();
      if (!derivatives_fault_.empty()) return end_at_fault();
      if (!factorize(row)) return false;
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
    row.filter_strength = strength_of(filter_);
    row.points_filtered = points_filtered_;
    if (!(slope < 0)) return end(Status::failed_line_search, "the Newton direction does not descend");
    if (confirm_scaled_ && solved_ && promises_little(row.decrement)) return end_scaled();
    if (options_.decrement_tolerance > 0 && solved_ && row.decrement <= options_.decrement_tolerance)
      return end(Status::converged_decrement, "the Newton decrement is within decrement_tolerance");
    LineSearchResult search;
    {
      const ScopedTimer timer(summary_.seconds.line_search);
      search =
          search_line(objective_, x_, direction_, summary_.energy, slope, energy_noise(), options_, trial_);
    }
    summary_.energy_evaluations += search.evaluations;
    if (!search.accepted)
      return search.at_roundoff
                 ? end(Status::converged_roundoff, "no step lowers the energy beyond its rounding")
                 : end(Status::failed_line_search, "no step along the direction lowers the energy");
    return accept(row, search);
  }

  bool accept(Iteration& row, const LineSearchResult& search) {
    const double before = summary_.energy, gradient_before = summary_.gradient_inf_norm;
    policy_.step_taken(search.step, search.model_fit);
    const bool full_step = search.step > 0.5 && search.step <= 1;
    last_decrement_ =
        exact_model_ && solved_ && full_step ? row.decrement : std::numeric_limits<double>::infinity();
    filter_ = policy_.first();
    previous_.swap(x_);
    x_.swap(trial_);
    const Evaluation at = differentiate();
    if (!std::isfinite(at.value)) {
      x_.swap(previous_);
      return end(Status::failed_line_search, "the energy is not finite after a step that was");
    }
    summary_.energy = at.value;
    ++summary_.iterations;
    objective_.accepted(x_);
    row.energy = at.value;
    row.step = search.step;
    row.model_fit = search.model_fit;
    row.evaluations = search.evaluations;
    if (!record(row)) return false;
    if (!derivatives_fault_.empty()) return end_at_fault();
    // Where energies are equal to rounding only the gradient can tell progress from a random walk.
    if (search.at_roundoff && summary_.gradient_inf_norm > 0.5 * gradient_before)
      return end(Status::converged_roundoff, "no step lowers energy or gradient beyond their rounding");
    if (options_.relative_energy_tolerance > 0 && search.step >= 1.0 &&
        before - at.value <= options_.relative_energy_tolerance * std::abs(at.value))
      return end(Status::converged_energy, "the energy changes less than relative_energy_tolerance");
    return true;
  }

  bool end(Status status, std::string message) {
    summary_.status = status;
    summary_.message = std::move(message);
    return false;
  }

  // Returns false, as there is no step to come.
  bool finish() {
    summary_.seconds.total = timer_.seconds();
    if (matrix_.size > 0 && kept_.linear) {
      const sparse::Statistics& statistics = kept_.linear->statistics();
      summary_.solver = std::string(sparse::backend_name(statistics.backend)) + " ";
      summary_.solver += statistics.backend == sparse::Backend::pcg
                             ? sparse::preconditioner_name(statistics.preconditioner)
                             : sparse::ordering_name(statistics.ordering);
      summary_.factor_nonzeros = statistics.factor_nonzeros;
    }
    log(LogLevel::debug,
        [&] { return "newton: " + summary_.brief_report() + ", solved with " + summary_.solver; });
    return false;
  }

  Kept& kept_;
  Objective& objective_;
  const Options& options_;
  sparse::SymmetricMatrix& matrix_;
  Vector x_;
  IterationCallback callback_;
  int version_ = 0;  // of the objective, at the start
  HessianPolicy policy_;
  Timer timer_;
  Summary summary_;
  projection::FilterOptions filter_;
  Vector gradient_, reduced_, direction_, trial_, previous_;
  double forced_norm_ = 0;  // |gradient| at the last inexact solve
  double typical_stiffness_ = 0;
  bool exact_model_ = false;  // the Hessian last factorised was neither filtered nor shifted
  // Of the step that led to x_, when it was a full one of an exact model: only then it says something about
  // x_.
  double last_decrement_ = std::numeric_limits<double>::infinity();
  bool confirm_scaled_ = false;  // the gradient has passed the scaled test, the decrement has yet to
  bool solved_ = false;  // the last linear system, as accurately as wanted: its decrement can be trusted
  double last_relative_shift_ = 0;
  std::size_t points_filtered_ = 0;
  std::string derivatives_fault_;  // why derivatives at x_ cannot be used; empty: they can
};

Solver::Solver(Objective& objective, const Options& options, std::unique_ptr<sparse::Solver> linear_solver)
    : kept_(std::make_unique<Kept>()) {
  options.validate();
  kept_->objective = &objective;
  kept_->options = options;
  kept_->handed_in = linear_solver != nullptr;
  kept_->linear = std::move(linear_solver);
}

Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

void Solver::require_startable(const Vector& x) const {
  const Objective& objective = *kept_->objective;
  if (x.size() != objective.dofs())
    throw Error("start of " + std::to_string(x.size()) + " entries for " + std::to_string(objective.dofs()) +
                " degrees of freedom");
  if (!objective.has_terms()) throw Error("the objective has no terms: there is nothing to minimize");
  objective.require_tied(x);
}

Summary Solver::solve(Vector& x, const IterationCallback& callback) {
  require_startable(x);
  current_.reset();
  Solve solve(*kept_, std::move(x), callback);
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
  current_ = std::make_unique<Solve>(*kept_, std::move(x), IterationCallback());
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
  if (!kept_->handed_in && options.solver != kept_->options.solver) {
    kept_->linear.reset();
    kept_->analyzed_version = -1;
  }
  kept_->options = options;
}

const Options& Solver::options() const {
  return kept_->options;
}

int Solver::analyses() const {
  return kept_->analyses;
}

Summary minimize(Objective& objective, Vector& x, const Options& options, const IterationCallback& callback) {
  return Solver(objective, options).solve(x, callback);
}

}  // namespace isostretch::newton

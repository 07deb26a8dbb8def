#include "progress.hpp"

#include "scaling.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/core/to_text.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace isostretch::sdp_penalty {
namespace {

// A field of ex-rotations is called infeasible when no x with all eigenvalues above this is in reach.
constexpr double least_reachable = 1e-2;

// Half the largest extent of the targets on an axis, and its middle, enlarged to hold x.
double extent_around(const Problem& problem, const Vector& x, std::vector<double>& middle) {
  const int dim = problem.dim();
  std::vector<double> low(static_cast<std::size_t>(dim), std::numeric_limits<double>::infinity()), high = low;
  for (double& h : high) h = -h;
  for (const Target& target : problem.targets)
    for (std::size_t r = 0; r < low.size(); ++r) {
      low[r] = std::min(low[r], target.position[r]);
      high[r] = std::max(high[r], target.position[r]);
    }
  double extent = 0;
  middle.resize(low.size());
  for (std::size_t r = 0; r < low.size(); ++r) {
    middle[r] = 0.5 * (low[r] + high[r]);
    extent = std::max(extent, high[r] - low[r]);
  }
  for (Eigen::Index i = 0; i < x.size(); ++i)
    extent = std::max(extent, std::abs(x[i] - middle[static_cast<std::size_t>(i % dim)]));
  return extent;
}

}  // namespace

Workspace::Workspace(const Problem& problem, const Options& options)
    : system(problem), unconstrained(options.solver), matrix(system.quadratic()), options_(options.solver) {}

sparse::Solver& Workspace::newton_solver() {
  if (!newton_solver_) {
    newton_solver_ = sparse::make_solver(options_);
    newton_solver_->analyze(matrix);
  }
  return *newton_solver_;
}

sparse::FactorResult Workspace::factorize() {
  return newton_solver().factorize(matrix);
}

Workspace::Direction Workspace::direction(const Vector& gradient) {
  const Vector right = -system.restrict_to_unknowns(gradient);
  Vector solution(right.size());
  newton_solver().solve_columns(right.data(), solution.data(), 1);
  return {system.prolongate(solution), right.dot(solution)};
}

Progress::Progress(Workspace& work, const Options& options, const IterationCallback& callback)
    : work_(work),
      options_(options),
      ends_at_certificate_(options.method != Method::penalty || !options.penalty.as_published),
      driver_(summary_, callback, options.stop, Status::callback) {}

void Progress::count_infeasible(Iteration& row, const Constrained& at_x) const {
  const System& system = work_.system;
  const double margin = system.problem().margin;
  const auto dim = static_cast<std::size_t>(system.dim());
  std::vector<double> lambda, stretch;
  block_eigen(system.dim(), at_x.orientation, lambda, nullptr);
  row.min_eigenvalue = *std::min_element(lambda.begin(), lambda.end());
  if (!at_x.stretch.empty()) block_eigen(2 * system.dim(), at_x.stretch, stretch, nullptr);
  const auto below = [](const std::vector<double>& values, std::size_t first, std::size_t count,
                        double least) {
    for (std::size_t k = first; k < first + count; ++k)
      if (!(values[k] >= least)) return true;
    return false;
  };
  for (std::size_t e = 0; e < system.blocks(); ++e)
    row.infeasible +=
        below(lambda, e * dim, dim, margin) || (!stretch.empty() && below(stretch, e * 2 * dim, 2 * dim, 0));
}

void Progress::record(Iteration row, const Vector& x, const Constrained& at_x,
                      const Constrained& multipliers) {
  const System& system = work_.system;
  row.energy = summary_.energy = energy(system.problem(), x);
  if (!std::isfinite(row.energy)) {
    row.min_eigenvalue = std::numeric_limits<double>::quiet_NaN();
    row.lower_bound = -std::numeric_limits<double>::infinity();
    row.inverted = row.infeasible = static_cast<int>(system.blocks());
    row.iteration = summary_.iterations;
    summary_.trace.push_back(row);
    return end(Status::failed, "the energy is not finite");
  }
  count_infeasible(row, at_x);
  system.gradient(x, gradient_);
  row.lower_bound = work_.unconstrained.lower_bound(gradient_, row.energy, at_x, multipliers);
  summary_.lower_bound = std::fmax(summary_.lower_bound, row.lower_bound);
  const auto determinants = system.determinants(x);
  row.inverted = static_cast<int>(
      std::count_if(determinants.begin(), determinants.end(), [](double d) { return !(d > 0); }));
  log(LogLevel::trace, [&] {
    return "sdp_penalty: iteration " + std::to_string(summary_.iterations) + ": energy " +
           to_text(row.energy) + ", bound " + to_text(row.lower_bound) + ", " + std::to_string(row.inverted) +
           " inverted";
  });
  // Before the callback is asked: what is certified stays so, whatever it says.
  if (ends_at_certificate_ && certified(row))
    end(Status::optimal, "feasible, and the certified gap is within gap_tolerance");
  driver_.record(row, x);
  if (options_.stop.deadline_passed()) end(Status::callback, "interrupted");
}

bool Progress::certified(const Iteration& row) const {
  // A bound above the energy of a feasible x is one of rounding, and proves nothing.
  return row.infeasible == 0 && summary_.lower_bound <= row.energy + 1e-9 * std::abs(row.energy) &&
         gap(row) <= options_.gap_tolerance;
}

double Progress::gap(const Iteration& row) const {
  const double reached = row.energy, bound = summary_.lower_bound;
  // Both may be 0 at rest but for rounding: energies are sums of squares of numbers around 1.
  const double rounding = 1e-15 * static_cast<double>(work_.system.blocks());
  return std::max(0.0, reached - bound) / std::max({std::abs(reached), std::abs(bound), rounding});
}

void Progress::name_infeasible_elements(const Constrained& multipliers) {
  const auto dim = static_cast<std::size_t>(work_.system.dim());
  std::vector<double> traces(work_.system.blocks(), 0.0);
  const auto add_traces = [&](const Blocks& Y, std::size_t d) {
    for (std::size_t e = 0; e < Y.size() / (d * d); ++e)
      for (std::size_t k = 0; k < d; ++k) traces[e] += Y[e * d * d + k * (d + 1)];
  };
  add_traces(multipliers.orientation, dim);
  add_traces(multipliers.stretch, 2 * dim);
  std::vector<int> order(traces.size());
  std::iota(order.begin(), order.end(), 0);
  const auto most = static_cast<std::ptrdiff_t>(std::min<std::size_t>(10, order.size()));
  const auto trace = [&](int e) { return traces[static_cast<std::size_t>(e)]; };
  std::partial_sort(order.begin(), order.begin() + most, order.end(),
                    [&](int a, int b) { return trace(a) > trace(b); });
  summary_.infeasible_elements.assign(order.begin(), order.begin() + most);
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "; largest multiplier, at element %d: trace %.3g", order[0],
                trace(order[0]));
  summary_.message += text.data();
}

// With all S_i >= e I and |x - middle| <= X:  e tr Y <= <Y, A x> = A^T Y . (x - middle) <= |A^T Y|_1 X, for
// translations change no S. Hard targets are at known places: they add A^T Y . (x_hard - middle) instead.
bool Progress::contradiction(const Vector& x, Blocks Y) {
  const Problem& problem = work_.system.problem();
  double trace = 0, largest = 0;
  for (const double entry : Y) largest = std::max(largest, std::abs(entry));
  if (!(largest > 0) || !std::isfinite(largest)) return false;
  for (double& entry : Y) entry /= largest;
  const std::size_t entries = work_.system.block_size(),
                    diagonal = static_cast<std::size_t>(problem.dim() + 1);
  for (std::size_t k = 0; k < Y.size(); ++k)
    if (k % entries % diagonal == 0) trace += Y[k];
  if (!(trace > 0) || !std::isfinite(trace)) return false;
  Vector pull = Vector::Zero(x.size());
  work_.system.add_adjoint(Y, pull);
  std::vector<double> middle;
  const double extent = 2 * extent_around(problem, x, middle);
  double reach = 0;
  std::vector<bool> hard(static_cast<std::size_t>(x.size()), false);
  for (const Target& target : problem.targets)
    for (std::size_t r = 0; target.hard && r < middle.size(); ++r) {
      const auto dof = static_cast<std::size_t>(target.node) * middle.size() + r;
      if (hard[dof]) continue;
      hard[dof] = true;
      reach += pull[static_cast<Eigen::Index>(dof)] * (target.position[r] - middle[r]);
    }
  for (std::size_t i = 0; i < hard.size(); ++i)
    if (!hard[i]) reach += std::abs(pull[static_cast<Eigen::Index>(i)]) * extent;
  summary_.unreachable_eigenvalue = reach / trace;
  summary_.extent = extent;
  return reach / trace < problem.margin + least_reachable;
}

void Progress::give_up(Status status, const std::string& reason, const Vector& x,
                       const Constrained& multipliers) {
  if (feasible())  // only the gap is open
    end(status == Status::failed ? Status::path_end : status, reason);
  else if (contradiction(x, multipliers.orientation))
    // Where stretch is bounded the multipliers of the orientations alone prove as much as ever.
    end(Status::infeasible,
        "no position to speak of is strictly feasible: ex-rotations or hard targets contradict each other (" +
            reason + ")");
  else
    end(status, reason);
  name_infeasible_elements(multipliers);
}

bool Progress::give_up_at_limit(const Vector& x, const Constrained& multipliers) {
  if (driver_.limit_reached(options_.max_iterations) != SolveStatus::iteration_limit) return false;
  give_up(Status::iterations, "max_iterations reached", x, multipliers);
  return true;
}

bool Progress::give_up_contradicted(const Vector& x, const Constrained& multipliers) {
  if (feasible() || !contradiction(x, multipliers.orientation)) return false;
  give_up(Status::failed, "multipliers grow without bound", x, multipliers);
  return true;
}

Summary Progress::finish(const Vector& x) {
  if (!summary_.trace.empty()) {
    const Iteration& row = last();
    summary_.min_eigenvalue = row.min_eigenvalue;
    summary_.inverted = row.inverted;
    summary_.infeasible = row.infeasible;
    summary_.target_energy = target_energy(work_.system.problem(), x);
    const auto determinants = work_.system.determinants(x);
    summary_.min_determinant = *std::min_element(determinants.begin(), determinants.end());
    if (feasible()) summary_.gap = gap();
  }
  summary_.seconds = driver_.seconds();
  log(LogLevel::debug, [&] {
    return "sdp_penalty: " + std::to_string(summary_.iterations) + " iterations, " +
           std::to_string(summary_.linear_solves) + " linear solves: " + summary_.message;
  });
  return std::move(summary_);
}

}  // namespace isostretch::sdp_penalty

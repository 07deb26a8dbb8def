#include "path.hpp"

#include <isostretch/core/backtracking.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::sdp_penalty {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double sufficient = 1e-4;  // Armijo's share of the promised decrease
constexpr int most_halvings = 50;
constexpr double published_decrement = 1e-14;

}  // namespace

Path::Path(Workspace& work, const Options& options, Progress& progress, Vector& x)
    : work_(work), options_(options), progress_(progress), x_(x) {
  work_.system.constraints(x_, S_);
}

Path::End Path::minimise(const ConePenalty& penalty, double tolerance) {
  penalty_ = &penalty;
  return minimise(false, tolerance);
}

Path::End Path::minimise_as_published(const ConePenalty& penalty) {
  penalty_ = &penalty;
  return minimise(true, 0);
}

Path::End Path::minimise(bool published, double tolerance) {
  penalty_->evaluate(work_.system.dim(), S_, state_);
  for (int i = 0; i < options_.penalty.level_iterations; ++i) {
    if (!newton_step()) return End::progress;
    if (published && decrement_ < published_decrement) return End::tolerance;
    const bool last = !published && decrement_ <= decrement_to_reach(tolerance);
    if (!search(published)) return End::tolerance;
    take_step();
    if (progress_.ended()) return End::progress;
    if (last) return End::tolerance;
  }
  return End::limit;
}

void Path::take_step() {
  x_ += step_ * dx_;
  work_.system.constraints(x_, S_);
  penalty_->evaluate(work_.system.dim(), S_, state_);
  progress_.count_iteration();
  Iteration row;
  row.penalty_factor = penalty_->stiffness();
  row.step = step_;
  progress_.record(row, x_, {S_, {}}, {state_.multiplier, {}});
}

bool Path::newton_step() {
  System& system = work_.system;
  if (progress_.give_up_at_limit(x_, {state_.multiplier, {}})) return false;
  Blocks pull = state_.multiplier;
  for (double& entry : pull) entry = -entry;
  gradient_ = progress_.gradient();
  system.add_adjoint(pull, gradient_);
  system.assemble_hessian(state_.curvature, work_.matrix);
  const sparse::FactorResult result = work_.factorize();
  progress_.count_solve();
  if (!result) {
    progress_.give_up(Status::failed, result.message, x_, {state_.multiplier, {}});
    return false;
  }
  Workspace::Direction direction = work_.direction(gradient_);
  dx_.swap(direction.dx);
  decrement_ = direction.decrement;
  return true;
}

// Of sums of penalties: eigenvalues y carry rounding errors of the size of S, and phi those that follow.
double Path::noise() const {
  const double S = 1 + state_.largest, count = state_.active() + 1;
  return penalty_->stiffness() * count * (unit * S) * (unit * S) + 8 * unit * std::abs(state_.sum());
}

double Path::decrement_to_reach(double tolerance) const {
  const double reached = progress_.last().energy, least = std::max(1e-16 * reached, noise());
  return progress_.feasible() ? least : std::max(tolerance * reached, least);
}

// Of f + phi: f is quadratic and S linear along the line, so that no digits are lost by subtracting sums.
double Path::change(double step) const {
  Blocks S = S_;
  for (std::size_t k = 0; k < S.size(); ++k) S[k] += step * change_of_S_[k];
  const std::vector<double> after = penalty_->values(work_.system.dim(), S);
  double sum = work_.system.change_of_objective(progress_.gradient(), dx_, step);
  for (std::size_t e = 0; e < after.size(); ++e) sum += after[e] - state_.value[e];
  return sum;
}

double Path::change_of_sums(double step) const {
  const System& system = work_.system;
  const Vector x = x_ + step * dx_;
  Blocks S;
  system.constraints(x, S);
  double after = energy(system.problem(), x);
  for (const double value : penalty_->values(system.dim(), S)) after += value;
  return after - (energy(system.problem(), x_) + state_.sum());
}

bool Path::search(bool published) {
  work_.system.constraints(dx_, change_of_S_);
  const double slack = published ? 0.0 : noise() + 8 * unit * unit * progress_.last().energy;
  const BacktrackedStep found = backtrack(
      {1, 0.5, 1 + most_halvings},
      [&](double step) { return published ? change_of_sums(step) : change(step); },
      [&](double step, double by) {
        return by <= -sufficient * step * decrement_ + slack ? Trial::accept : Trial::shorten;
      });
  step_ = found.step;
  return found.accepted;
}

}  // namespace isostretch::sdp_penalty

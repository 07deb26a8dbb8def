#include "certificate.hpp"
#include "scaling.hpp"
#include "small_matrix.hpp"
#include "system.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/sdp_penalty/interior_point.hpp>
#include <isostretch/sparse/solver.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace isostretch::sdp_penalty {
namespace {

using Blocks = std::vector<double>;

// What the slacks are kept above besides the margin, so that rounding of S leaves x feasible; it costs the
// sum of the multipliers' traces times this, some 1e-10 of the energy.
constexpr double room = 1e-10;

// out_i = T_i A_i T_i^T, or with the transposes T_i^T A_i T_i.
template <int D>
void congruence(const Blocks& T, const Blocks& A, bool transpose, Blocks& out) {
  out.resize(A.size());
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < A.size(); k += D * D) {
    Small<D> t = load<D>(T.data() + k);
    if (transpose) t = transposed(t);
    store(t * load<D>(A.data() + k) * transposed(t), out.data() + k);
  }
}

// Largest t <= limit with diag(l) + t D_i positive semi-definite for all blocks D_i.
double largest_step(int dim, const std::vector<double>& l, const Blocks& D, double limit) {
  Blocks relative(D.size());
  const std::size_t d = static_cast<std::size_t>(dim);
  for (std::size_t i = 0; i < D.size() / (d * d); ++i)
    for (std::size_t r = 0; r < d; ++r)
      for (std::size_t c = 0; c < d; ++c)
        relative[(i * d + r) * d + c] = D[(i * d + r) * d + c] / std::sqrt(l[i * d + r] * l[i * d + c]);
  std::vector<double> lambda;
  block_eigen(dim, relative, lambda, nullptr);
  const double smallest = *std::min_element(lambda.begin(), lambda.end());
  return smallest < 0 ? std::min(limit, -1 / smallest) : limit;
}

class InteriorPoint {
 public:
  InteriorPoint(const Problem& problem, Vector& x, const InteriorPointOptions& options,
                const IterationCallback& callback)
      : problem_(problem),
        options_(options),
        callback_(callback),
        x_(x),
        system_(problem),
        unconstrained_(system_, options.solver),
        dim_(static_cast<std::size_t>(problem.dim())) {}

  Summary run() {
    start();
    while (summary_.status == Status::not_run) iterate();
    finish();
    return std::move(summary_);
  }

 private:
  void start() {
    x_ = unconstrained_.minimiser();
    ++summary_.linear_solves;
    matrix_ = system_.quadratic();
    system_.constraints(x_, S_);
    Y_.assign(S_.size(), 0.0);
    if (!record(0)) return;
    if (summary_.trace.back().min_eigenvalue >= problem_.margin) {
      summary_.lower_bound = summary_.energy;  // nothing holds it back
      return end(Status::optimal, "the minimiser without constraints satisfies them");
    }
    solver_ = sparse::make_solver(options_.solver);
    solver_->analyze(matrix_);
    start_slacks();
  }

  // Z from S with eigenvalues of at least least_eigenvalue, Y the inverse.
  void start_slacks() {
    std::vector<double> lambda;
    Blocks Q;
    block_eigen(problem_.dim(), S_, lambda, &Q);
    Z_.assign(S_.size(), 0.0);
    Y_.assign(S_.size(), 0.0);
    for (std::size_t i = 0; i < system_.blocks(); ++i)
      for (std::size_t k = 0; k < dim_; ++k) {
        const double z = std::max(lambda[i * dim_ + k] - problem_.margin, options_.least_eigenvalue);
        for (std::size_t r = 0; r < dim_; ++r)
          for (std::size_t c = 0; c < dim_; ++c) {
            const double qq = Q[at(i, r, k)] * Q[at(i, c, k)];
            Z_[at(i, r, c)] += z * qq;
            Y_[at(i, r, c)] += qq / z;
          }
      }
  }

  std::size_t at(std::size_t block, std::size_t r, std::size_t c) const {
    return (block * dim_ + r) * dim_ + c;
  }

  bool record(double step) {
    Iteration row;
    row.iteration = summary_.iterations;
    row.seconds = timer_.seconds();
    row.step = step;
    row.energy = summary_.energy = system_.objective(x_);
    std::vector<double> lambda;
    block_eigen(problem_.dim(), S_, lambda, nullptr);
    row.min_eigenvalue = *std::min_element(lambda.begin(), lambda.end());
    row.lower_bound = unconstrained_.lower_bound(x_, S_, Y_, problem_.margin);
    summary_.lower_bound = std::max(summary_.lower_bound, row.lower_bound);
    row.complementarity = Z_.empty() ? 0.0 : complementarity();
    const auto determinants = system_.determinants(x_);
    row.inverted = static_cast<int>(
        std::count_if(determinants.begin(), determinants.end(), [](double d) { return !(d > 0); }));
    summary_.trace.push_back(row);
    if (!std::isfinite(row.energy)) {
      end(Status::failed, "the energy is not finite");
      return false;
    }
    if (callback_ && callback_(row, x_) == CallbackAction::stop) {
      end(Status::callback, "stopped by the callback");
      return false;
    }
    return true;
  }

  double complementarity() const {
    return std::inner_product(Z_.begin(), Z_.end(), Y_.begin(), 0.0) / static_cast<double>(S_.size() / dim_);
  }

  double gap() const {
    const double bound = summary_.lower_bound;
    return (summary_.energy - bound) / std::max({std::abs(summary_.energy), std::abs(bound), 1e-300});
  }

  void iterate() {
    if (summary_.iterations >= options_.max_iterations)
      return give_up(Status::iterations, "max_iterations reached");
    if (!scaling_.compute(problem_.dim(), Z_, Y_))
      return give_up(Status::failed, "rounding has taken slacks or multipliers to the boundary");
    if (!factorize()) return;
    // Predictor: all the way, no centring.
    const double mu = complementarity();
    set_target(nullptr, nullptr, 0);
    solve_direction();
    const double reach = std::min(largest_step(problem_.dim(), scaling_.l, dZ_, 1),
                                  largest_step(problem_.dim(), scaling_.l, dY_, 1));
    // Corrector, with the centring of Mehrotra.
    const double share = 1 - reach, centring = share * share * share;
    const Blocks predictor_Z = dZ_, predictor_Y = dY_;
    set_target(&predictor_Z, &predictor_Y, centring * mu);
    solve_direction();
    const double limit = 1 / options_.step_fraction;
    advance(options_.step_fraction * std::min(largest_step(problem_.dim(), scaling_.l, dZ_, limit),
                                              largest_step(problem_.dim(), scaling_.l, dY_, limit)));
  }

  bool factorize() {
    system_.weighted(scaling_.weight, matrix_);
    const sparse::FactorResult result = solver_->factorize(matrix_);
    ++summary_.linear_solves;
    if (!result) give_up(Status::failed, result.message);
    return static_cast<bool>(result);
  }

  // C with C_jk = 2 c_jk / (l_j + l_k) and c = centre I - diag(l)^2 - sym(dZ dY) of a predictor: what the
  // scaled directions have to add up to.
  void set_target(const Blocks* dZ, const Blocks* dY, double centre) {
    target_.assign(S_.size(), 0.0);
    for (std::size_t i = 0; i < system_.blocks(); ++i)
      for (std::size_t r = 0; r < dim_; ++r)
        for (std::size_t c = 0; c < dim_; ++c) {
          const double lr = scaling_.l[i * dim_ + r], lc = scaling_.l[i * dim_ + c];
          double value = r == c ? centre - lr * lr : 0.0;
          for (std::size_t k = 0; dZ != nullptr && k < dim_; ++k)
            value -=
                0.5 * ((*dZ)[at(i, r, k)] * (*dY)[at(i, k, c)] + (*dY)[at(i, r, k)] * (*dZ)[at(i, k, c)]);
          target_[at(i, r, c)] = 2 * value / (lr + lc);
        }
  }

  void scale(const Blocks& T, const Blocks& A, bool transpose, Blocks& out) const {
    if (dim_ == 2)
      congruence<2>(T, A, transpose, out);
    else
      congruence<3>(T, A, transpose, out);
  }

  // dx_, and the directions of Z and Y in the scaled space.
  void solve_direction() {
    Blocks residual = S_;  // of the slacks: S - (margin + room) I - Z
    for (std::size_t i = 0; i < system_.blocks(); ++i)
      for (std::size_t k = 0; k < dim_; ++k) residual[at(i, k, k)] -= problem_.margin + room;
    for (std::size_t k = 0; k < residual.size(); ++k) residual[k] -= Z_[k];
    Blocks scaled, pull;
    scale(scaling_.inverse, residual, false, scaled);
    for (std::size_t k = 0; k < scaled.size(); ++k) scaled[k] = target_[k] - scaled[k];
    scale(scaling_.inverse, scaled, true, pull);
    for (std::size_t k = 0; k < pull.size(); ++k) pull[k] += Y_[k];
    Vector right;
    system_.gradient(x_, right);
    right = -right;
    system_.add_adjoint(pull, right);
    dx_.resize(right.size());
    solver_->solve_columns(right.data(), dx_.data(), 1);
    Blocks change;
    system_.constraints(dx_, change);
    for (std::size_t k = 0; k < change.size(); ++k) change[k] += residual[k];
    change_Z_ = change;
    scale(scaling_.inverse, change, false, dZ_);
    dY_.resize(dZ_.size());
    for (std::size_t k = 0; k < dZ_.size(); ++k) dY_[k] = target_[k] - dZ_[k];
  }

  void advance(double step) {
    Blocks change_Y;
    scale(scaling_.inverse, dY_, true, change_Y);
    x_ += step * dx_;
    for (std::size_t k = 0; k < Z_.size(); ++k) {
      Z_[k] += step * change_Z_[k];
      Y_[k] += step * change_Y[k];
    }
    system_.constraints(x_, S_);
    ++summary_.iterations;
    if (!record(step)) return;
    if (summary_.trace.back().min_eigenvalue >= problem_.margin && gap() <= options_.gap_tolerance)
      end(Status::optimal, "feasible, and the certified gap is within gap_tolerance");
  }

  void give_up(Status status, const std::string& reason) {
    std::vector<double> traces(system_.blocks(), 0.0);
    for (std::size_t i = 0; i < traces.size(); ++i)
      for (std::size_t k = 0; k < dim_; ++k) traces[i] += Y_[at(i, k, k)];
    std::vector<int> order(traces.size());
    std::iota(order.begin(), order.end(), 0);
    const std::size_t most = std::min<std::size_t>(10, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end(),
                      [&](int a, int b) {
                        return traces[static_cast<std::size_t>(a)] > traces[static_cast<std::size_t>(b)];
                      });
    summary_.suspects.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most));
    end(status, reason + "; largest multiplier, at element " + std::to_string(order[0]) + ": trace " +
                    std::to_string(traces[static_cast<std::size_t>(order[0])]));
  }

  void end(Status status, std::string message) {
    summary_.status = status;
    summary_.message = std::move(message);
  }

  void finish() {
    const Iteration& last = summary_.trace.back();
    summary_.min_eigenvalue = last.min_eigenvalue;
    summary_.inverted = last.inverted;
    summary_.target_energy = system_.target_energy(x_);
    const auto determinants = system_.determinants(x_);
    summary_.min_determinant = *std::min_element(determinants.begin(), determinants.end());
    if (last.min_eigenvalue >= problem_.margin) summary_.gap = std::max(0.0, gap());
    summary_.seconds = timer_.seconds();
  }

  const Problem& problem_;
  const InteriorPointOptions& options_;
  const IterationCallback& callback_;
  Timer timer_;
  Vector& x_;
  System system_;
  Unconstrained unconstrained_;
  std::size_t dim_;
  Summary summary_;
  sparse::SymmetricMatrix matrix_;
  std::unique_ptr<sparse::Solver> solver_;
  Scaling scaling_;
  Blocks S_, Z_, Y_, target_, dZ_, dY_, change_Z_;
  Vector dx_;
};

}  // namespace

void InteriorPointOptions::validate() const {
  const auto require = [](bool condition, const char* text) {
    if (!condition) throw Error(std::string("interior point options: ") + text);
  };
  require(gap_tolerance > 0 && gap_tolerance < 1, "gap_tolerance must be between 0 and 1");
  require(max_iterations >= 0, "max_iterations must not be negative");
  require(step_fraction > 0 && step_fraction < 1, "step_fraction must be between 0 and 1");
  require(least_eigenvalue > 0 && std::isfinite(least_eigenvalue), "least_eigenvalue must be positive");
}

Summary solve_interior_point(const Problem& problem, Vector& x, const InteriorPointOptions& options,
                             const IterationCallback& callback) {
  problem.validate();
  options.validate();
  return InteriorPoint(problem, x, options, callback).run();
}

}  // namespace isostretch::sdp_penalty

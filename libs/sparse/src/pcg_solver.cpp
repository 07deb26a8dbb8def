#include "pcg_solver.hpp"

#include "preconditioner.hpp"
#include "vector_operations.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace isostretch::sparse {
namespace {

std::string scientific(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, 2).ptr};
}

enum class Descent { converged, limit, negative_curvature, not_finite };

// Preconditioned conjugate gradients (Hestenes & Stiefel 1952), started from zero; truncated where the
// curvature is negative (Steihaug 1983). The recurrence for the residual drifts from the true one, so
// convergence counts only when b - A x itself is small; otherwise it starts again from x.
class PcgSolver final : public Solver {
 public:
  explicit PcgSolver(const Options& options) : options_(options), method_(make_preconditioner(options)) {
    statistics_.backend = Backend::pcg;
    statistics_.ordering = Ordering::natural;
    statistics_.preconditioner = options.pcg_preconditioner;
    tolerance_ = options.pcg_tolerance;
  }

 private:
  void do_set_tolerance(double tolerance) override { tolerance_ = tolerance; }

  void do_set_coordinates(const double* positions, int dim, int nodes,
                          const std::vector<int>& axis) override {
    coordinates_.position.assign(positions, positions + static_cast<std::size_t>(dim) * nodes);
    coordinates_.dim = dim;
    coordinates_.axis = axis;
  }

  FactorResult do_analyze(const SymmetricMatrix& A) override {
    made_ = false;
    system_.analyze(A, coordinates_);
    for (std::vector<double>* vector : {&b_, &x_, &residual_, &z_, &direction_, &product_})
      vector->assign(system_.size(), 0.0);
    const FactorResult result = method_->analyze(A, system_);
    method_->report(statistics_);
    return result;
  }

  FactorResult do_factorize(const SymmetricMatrix& A) override {
    system_.gather(A.value);
    fresh_ = false;
    if (made_ && !renew_ && method_->stale_iterations() > 0) return {};
    return renew();
  }

  FactorResult renew() {
    ++statistics_.factorizations;
    const FactorResult result = method_->factorize(system_, coordinates_);
    method_->report(statistics_);
    made_ = fresh_ = static_cast<bool>(result);
    renew_ = false;
    last_renewal_ = result;
    return result;
  }

  SolveResult do_solve(const double* b, double* x, int columns) override {
    SolveResult all;
    const auto size = static_cast<std::ptrdiff_t>(unknowns());
    for (int c = 0; c < columns; ++c, b += size, x += size) {
      const SolveResult one = solve_one(b, x);
      all.iterations += one.iterations;
      all.relative_residual = std::max(all.relative_residual, one.relative_residual);
      if (!one && all) {
        all.status = one.status;
        all.message = one.message;
      }
    }
    statistics_.multiplications += all.iterations;
    return all;
  }

  // Solves for b / max |b|: no square of an entry overflows or vanishes then.
  SolveResult solve_one(const double* b, double* x) {
    system_.pad(b, b_.data());
    std::fill(x_.begin(), x_.end(), 0.0);
    const double unit = max_magnitude(b_.data(), system_.size());
    SolveResult result;
    if (unit > 0) {
      for (double& entry : b_) entry /= unit;
      result = iterate();
      if (result.status != SolveStatus::ok || result.iterations > method_->stale_iterations()) renew_ = true;
      for (double& entry : x_) entry *= unit;
    }
    system_.unpad(x_.data(), x);
    return result;
  }

  SolveResult iterate() {
    // A renewal may have failed in an earlier solve: there is no preconditioner then.
    if (!made_) {
      SolveResult none;
      none.relative_residual = 1;
      return stopped(none, status_of(last_renewal_), last_renewal_.message.c_str());
    }
    const int limit = options_.pcg_max_iterations > 0 ? options_.pcg_max_iterations : 10 * unknowns() + 100;
    SolveResult result;
    const double b_norm = std::sqrt(dot(b_, b_));
    residual_ = b_;
    result.relative_residual = 1;
    // A second round aims lower: the recurrence has drifted above the true residual's target before.
    for (double target = tolerance_ * b_norm;; target *= 0.5) {
      const double before = result.relative_residual;
      const Descent end = descend(target, std::min(limit, patience(result)), result.iterations);
      multiply(system_.matrix(), x_.data(), residual_.data());
      result.relative_residual = std::sqrt(residual_from_product(b_, residual_)) / b_norm;
      if (result.relative_residual <= tolerance_) return result;
      if (end == Descent::negative_curvature)
        return stopped(result, SolveStatus::not_positive_definite, "direction of negative curvature");
      if (end == Descent::not_finite) return stopped(result, SolveStatus::failed, "overflow");
      if (result.iterations >= limit) return stopped(result, SolveStatus::not_converged, "iteration limit");
      if (end == Descent::limit) {
        const FactorResult renewed = renew();
        if (!renewed) return stopped(result, status_of(renewed), renewed.message.c_str());
        continue;
      }
      // A fresh start that gains nothing has met the rounding of A x.
      if (!(result.relative_residual < 0.5 * before))
        return stopped(result, SolveStatus::not_converged, "no further progress");
    }
  }

  // With a preconditioner of an earlier matrix that serves badly it is better not to go on to the end.
  int patience(const SolveResult& result) const {
    constexpr int none = 1 << 30;
    return fresh_ || result.iterations > 0 ? none : 2 * method_->stale_iterations();
  }

  // Improves x_ from residual_ = b - A x until the recurrence says `target`.
  Descent descend(double target, int limit, int& iterations) {
    method_->apply(residual_.data(), z_.data());
    direction_ = z_;
    double rho = dot(residual_, z_), norm = std::sqrt(dot(residual_, residual_));
    while (norm > target) {
      if (iterations >= limit) return Descent::limit;
      ++iterations;
      multiply(system_.matrix(), direction_.data(), product_.data());
      const double curvature = dot(direction_, product_);
      if (!std::isfinite(curvature) || !std::isfinite(rho)) return Descent::not_finite;
      // The preconditioner of a positive definite matrix is so as well.
      if (!(curvature > 0 && rho > 0)) return Descent::negative_curvature;
      norm = std::sqrt(advance(rho / curvature, direction_, product_, x_, residual_));
      if (!std::isfinite(norm)) return Descent::not_finite;
      if (norm <= target) break;
      method_->apply(residual_.data(), z_.data());
      const double next = dot(residual_, z_);
      update_direction(z_, next / rho, direction_);
      rho = next;
    }
    return Descent::converged;
  }

  int unknowns() const { return static_cast<int>(system_.unknowns()); }

  static SolveStatus status_of(const FactorResult& result) {
    return result.status == FactorStatus::not_positive_definite ? SolveStatus::not_positive_definite
                                                                : SolveStatus::failed;
  }

  static SolveResult stopped(SolveResult result, SolveStatus status, const char* reason) {
    result.status = status;
    result.message = std::string("conjugate gradients: ") + reason + " after " +
                     std::to_string(result.iterations) + " iterations, relative residual " +
                     scientific(result.relative_residual);
    return result;
  }

  Options options_;
  Coordinates coordinates_;
  NodeSystem system_;
  std::unique_ptr<PreconditionerMethod> method_;
  FactorResult last_renewal_;
  bool made_ = false;   // there is a preconditioner
  bool fresh_ = false;  // made for the matrix at hand
  bool renew_ = false;  // make one for the next matrix
  double tolerance_ = 0;
  std::vector<double> b_, x_, residual_, z_, direction_, product_;
};

}  // namespace

std::unique_ptr<Solver> make_pcg_solver(const Options& options) {
  return std::make_unique<PcgSolver>(options);
}

}  // namespace isostretch::sparse

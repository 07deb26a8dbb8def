#include "pcg_solver.hpp"

#include "preconditioner.hpp"

#include <isostretch/core/vector.hpp>

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

// Without overflow or underflow on the way.
double norm(const Eigen::Ref<const Vector>& x) {
  const double scale = x.cwiseAbs().maxCoeff();
  return scale > 0 && std::isfinite(scale) ? scale * (x / scale).norm() : scale;
}

// Preconditioned conjugate gradients (Hestenes & Stiefel 1952), started from zero. The recurrence for the
// residual drifts from the true one, so convergence counts only when b - A x itself is small; otherwise it
// starts again from x.
class PcgSolver final : public Solver {
 public:
  explicit PcgSolver(const Options& options) : options_(options) {
    statistics_.backend = Backend::pcg;
    statistics_.ordering = Ordering::natural;
  }

 private:
  FactorResult do_analyze(const SymmetricMatrix& A) override {
    preconditioner_.analyze(A, options_.pcg_preconditioner);
    return {};
  }

  FactorResult do_factorize(const SymmetricMatrix& A) override {
    const FactorResult result = preconditioner_.factorize(A);
    if (result) matrix_ = A;
    return result;
  }

  SolveResult do_solve(const double* b, double* x, int columns) override {
    SolveResult all;
    for (int c = 0; c < columns; ++c, b += matrix_.size, x += matrix_.size) {
      const SolveResult one = solve_one(b, x);
      all.iterations += one.iterations;
      all.relative_residual = std::max(all.relative_residual, one.relative_residual);
      if (!one && all) {
        all.status = one.status;
        all.message = one.message;
      }
    }
    return all;
  }

  SolveResult solve_one(const double* b_data, double* x_data) {
    const Eigen::Map<const Vector> b(b_data, matrix_.size);
    Eigen::Map<Vector> x(x_data, matrix_.size);
    x.setZero();
    SolveResult result;
    const double b_norm = norm(b);
    if (b_norm == 0) return result;
    const int limit = options_.pcg_max_iterations > 0 ? options_.pcg_max_iterations : 10 * matrix_.size + 100;
    residual_ = b;
    result.relative_residual = 1;
    for (;;) {
      const double before = result.relative_residual;
      const bool curved = descend(x, options_.pcg_tolerance * b_norm, limit, result.iterations);
      product_.resize(matrix_.size);
      matrix_.multiply(x.data(), product_.data());
      residual_ = b - product_;
      result.relative_residual = norm(residual_) / b_norm;
      if (result.relative_residual <= options_.pcg_tolerance) return result;
      if (curved)
        return stopped(result, SolveStatus::not_positive_definite, "direction of negative curvature");
      if (result.iterations >= limit) return stopped(result, SolveStatus::not_converged, "iteration limit");
      // A fresh start that gains nothing has met the rounding of A x.
      if (!(result.relative_residual < 0.5 * before))
        return stopped(result, SolveStatus::not_converged, "no further progress");
    }
  }

  // Improves x from residual_ = b - A x until the recurrence says `target`; true: met p^T A p <= 0.
  bool descend(Eigen::Map<Vector>& x, double target, int limit, int& iterations) {
    z_.resize(matrix_.size);
    product_.resize(matrix_.size);
    preconditioner_.apply(residual_.data(), z_.data());
    direction_ = z_;
    double rho = residual_.dot(z_);
    while (iterations < limit && norm(residual_) > target) {
      ++iterations;
      matrix_.multiply(direction_.data(), product_.data());
      const double curvature = direction_.dot(product_);
      if (!(curvature > 0)) return true;
      const double step = rho / curvature;
      x += step * direction_;
      residual_ -= step * product_;
      preconditioner_.apply(residual_.data(), z_.data());
      const double next = residual_.dot(z_);
      direction_ = z_ + (next / rho) * direction_;
      rho = next;
    }
    return false;
  }

  static SolveResult stopped(SolveResult result, SolveStatus status, const char* reason) {
    result.status = status;
    result.message = std::string("conjugate gradients: ") + reason + " after " +
                     std::to_string(result.iterations) + " iterations, relative residual " +
                     scientific(result.relative_residual);
    return result;
  }

  Options options_;
  SymmetricMatrix matrix_;
  BlockDiagonal preconditioner_;
  Vector residual_, z_, direction_, product_;
};

}  // namespace

std::unique_ptr<Solver> make_pcg_solver(const Options& options) {
  return std::make_unique<PcgSolver>(options);
}

}  // namespace isostretch::sparse

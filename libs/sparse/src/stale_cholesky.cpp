#include "stale_cholesky.hpp"

#include "direct_solver.hpp"

#include <algorithm>

namespace isostretch::sparse {
namespace {

// A factorization takes about as long as 0.015 flops / nonzeros multiplications with solutions (README.md);
// half of that is a good time for a new one.
constexpr double share_of_flops = 0.0075;
constexpr int least_stale_iterations = 4, if_unknown = 20;

}  // namespace

StaleCholesky::StaleCholesky(const Options& options)
    : factor_(make_direct_solver(options)), wanted_iterations_(options.stale_max_iterations) {}

FactorResult StaleCholesky::analyze(const SymmetricMatrix& A, const NodeSystem& system) {
  matrix_ = A;
  system_ = &system;
  right_.resize(A.size);
  solution_.resize(A.size);
  return factor_->analyze(matrix_);
}

FactorResult StaleCholesky::factorize(const NodeSystem& system, const Coordinates&) {
  system.restore(matrix_.value);
  return factor_->factorize(matrix_);
}

int StaleCholesky::stale_iterations() const {
  const Statistics& factor = factor_->statistics();
  if (wanted_iterations_ > 0) return wanted_iterations_;
  if (!(factor.factor_flops > 0)) return if_unknown;
  return std::max(least_stale_iterations,
                  static_cast<int>(share_of_flops * factor.factor_flops / factor.factor_nonzeros));
}

void StaleCholesky::apply(const double* r, double* z) {
  system_->unpad(r, right_.data());
  factor_->solve_columns(right_.data(), solution_.data(), 1);
  system_->pad(solution_.data(), z);
}

void StaleCholesky::report(Statistics& statistics) const {
  const Statistics& factor = factor_->statistics();
  statistics.ordering = factor.ordering;
  statistics.orderings = factor.orderings;
  statistics.ordering_seconds = factor.ordering_seconds;
  statistics.factor_nonzeros = factor.factor_nonzeros;
  statistics.factor_flops = factor.factor_flops;
  statistics.factor_bytes = factor.factor_bytes;
}

}  // namespace isostretch::sparse

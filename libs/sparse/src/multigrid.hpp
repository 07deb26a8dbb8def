#pragma once

#include "gauss_seidel.hpp"
#include "preconditioner.hpp"
#include "prolongator.hpp"

#include <vector>

namespace isostretch::sparse {

// Smoothed aggregation (Vanek, Mandel & Brezina 1996): neighbouring nodes are taken together to aggregates,
// whose few unknowns say how much of every near-nullspace mode each has; and so on until a dense matrix is
// left. One V-cycle, made in double, kept and run in single precision: it only has to point the right way.
class Multigrid final : public PreconditionerMethod {
 public:
  explicit Multigrid(const Options& options);
  FactorResult factorize(const NodeSystem& system, const Coordinates& coordinates) override;
  void apply(const double* r, double* z) override;
  int stale_iterations() const override { return stale_iterations_; }

 private:
  struct Level {
    BlockCsr<float> A, prolong, restrict;
    GaussSeidel smoother;
    std::vector<float> right, x, residual;
  };

  // Appends a level; false: A is indefinite in row bad_.
  bool add_level(const BlockCsr<double>& A, std::vector<double>& inverse);
  // The matrix of the next level, with no rows where there is no use in one.
  BlockCsr<double> coarsen(const BlockCsr<double>& A, const std::vector<double>& inverse,
                           NearNullspace& modes);
  bool factorize_dense(const BlockCsr<double>& A);
  void cycle(std::size_t at);
  void solve_dense(const std::vector<float>& right, std::vector<float>& x);

  int stale_iterations_;
  std::vector<Level> levels_;  // the last one has no `prolong`
  std::vector<double> dense_;  // factor of the last level's matrix; empty: the last level is only smoothed
  std::vector<double> dense_right_;
  double scale_ = 1;
  int bad_ = -1;
};

}  // namespace isostretch::sparse

#include "multigrid.hpp"

#include "diagonal_blocks.hpp"
#include "vector_operations.hpp"

#include <algorithm>

namespace isostretch::sparse {
namespace {

constexpr int dense_size = 600;
constexpr double strength = 0.08;  // measured; halved from level to level, as the method has it
constexpr int default_stale_iterations = 40;

// Modes that depend on others have no coarse unknown: an equation of its own keeps the matrix regular.
void fill_up_diagonal(BlockCsr<double>& A) {
  const double scale = largest_diagonal(A);
  const int b = A.height;
  for (int i = 0; i < A.rows; ++i) {
    double* block = A.block(A.find(i, i));
    for (int r = 0; r < b; ++r)
      if (block[b * r + r] == 0) block[b * r + r] = scale > 0 ? scale : 1;
  }
}

}  // namespace

Multigrid::Multigrid(const Options& options)
    : stale_iterations_(options.stale_max_iterations > 0 ? options.stale_max_iterations
                                                         : default_stale_iterations) {}

FactorResult Multigrid::factorize(const NodeSystem& system, const Coordinates& coordinates) {
  levels_.clear();
  dense_.clear();
  const BlockCsr<double>* A = &system.matrix();
  BlockCsr<double> coarse;
  scale_ = 1 / std::max(largest_diagonal(*A), 1e-300);
  NearNullspace modes = near_nullspace(system, coordinates);
  std::vector<double> inverse;
  for (;;) {
    if (!add_level(*A, inverse))
      return not_positive_definite(system, levels_.size() == 1 ? bad_ : -1, " of a diagonal block");
    if (A->rows * A->height <= dense_size) {
      if (!factorize_dense(*A)) return not_positive_definite(system, -1, " of a coarse matrix");
      return {};
    }
    BlockCsr<double> next = coarsen(*A, inverse, modes);
    if (next.rows == 0) return {};
    coarse = std::move(next);
    A = &coarse;
  }
}

bool Multigrid::add_level(const BlockCsr<double>& A, std::vector<double>& inverse) {
  Level& level = levels_.emplace_back();
  bad_ = level.smoother.setup(A, scale_, inverse);
  if (bad_ >= 0) return false;
  level.A = to_float(A, scale_);
  const auto size = static_cast<std::size_t>(A.rows) * A.height;
  for (std::vector<float>* vector : {&level.right, &level.x, &level.residual}) vector->resize(size);
  return true;
}

BlockCsr<double> Multigrid::coarsen(const BlockCsr<double>& A, const std::vector<double>& inverse,
                                    NearNullspace& modes) {
  const double threshold = strength / static_cast<double>(1 << (levels_.size() - 1));
  const std::vector<char> strong = strong_couplings(A, threshold);
  const Aggregates aggregates = aggregate(A, strong);
  // Little would be gained by the next level, or there is nothing to correct on it.
  if (aggregates.count == 0 || aggregates.count * modes.count > 0.8 * A.rows * A.height) return {};
  NearNullspace coarse_modes;
  const BlockCsr<double> T = tentative_prolongator(modes, A.height, aggregates, coarse_modes);
  modes = std::move(coarse_modes);
  const bool all_strong = std::find(strong.begin(), strong.end(), 0) == strong.end();
  const BlockCsr<double> P = all_strong ? smoothed_prolongator(A, A, inverse, T)
                                        : smoothed_prolongator(A, lump_weak(A, strong), inverse, T);
  const BlockCsr<double> R = transpose(P);
  levels_.back().prolong = to_float(P, 1);
  levels_.back().restrict = to_float(R, 1);
  BlockCsr<double> coarse = product(R, product(A, P));
  fill_up_diagonal(coarse);
  return coarse;
}

bool Multigrid::factorize_dense(const BlockCsr<double>& A) {
  const int b = A.height, n = b * A.rows;
  dense_.assign(static_cast<std::size_t>(n) * n, 0.0);
  dense_right_.resize(n);
  for (int i = 0; i < A.rows; ++i)
    for (int k = A.start[i]; k < A.start[i + 1]; ++k)
      for (int r = 0; r < b; ++r)
        for (int c = 0; c < b; ++c)
          dense_[static_cast<std::size_t>(n) * (b * A.column[k] + c) + b * i + r] =
              scale_ * A.block(k)[b * r + c];
  return cholesky(dense_.data(), n) < 0;
}

void Multigrid::solve_dense(const std::vector<float>& right, std::vector<float>& x) {
  std::copy(right.begin(), right.end(), dense_right_.begin());
  cholesky_solve(dense_.data(), static_cast<int>(right.size()), dense_right_.data());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<float>(dense_right_[i]);
}

void Multigrid::cycle(std::size_t at) {
  Level& level = levels_[at];
  const bool last = at + 1 == levels_.size();
  if (last && !dense_.empty()) return solve_dense(level.right, level.x);
  level.smoother.forward(level.A, level.right.data(), level.x.data(), level.residual.data());
  if (!last) {
    Level& coarse = levels_[at + 1];
    multiply(level.restrict, level.residual.data(), coarse.right.data());
    cycle(at + 1);
    multiply_add(level.prolong, coarse.x.data(), level.x.data());
  }
  level.smoother.backward(level.A, level.right.data(), level.x.data());
}

void Multigrid::apply(const double* r, double* z) {
  Level& top = levels_.front();
  const int size = static_cast<int>(top.right.size());
  const double largest = max_magnitude(r, size), unit = largest > 0 ? largest : 1;
  for (int i = 0; i < size; ++i) top.right[i] = static_cast<float>(r[i] / unit);
  cycle(0);
  for (int i = 0; i < size; ++i) z[i] = unit * scale_ * static_cast<double>(top.x[i]);
}

}  // namespace isostretch::sparse

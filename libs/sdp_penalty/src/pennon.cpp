// The augmented Lagrangian of PENNON (Kocvara, Stingl 2003): tr(U (p^2 W - p I)), W = (p I - A)^-1, a barrier
// at the eigenvalue p of A. Its Hessian in the basis T = L Q, with W = L L^T and L^T U L = Q diag(n) Q^T, is
// p^2 sum_jk (n_j + n_k) (T^T dS T)_jk^2.
#include "methods.hpp"
#include "multiplier_method.hpp"
#include "scaling.hpp"

#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/linalg/cholesky.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::sdp_penalty {
namespace {

using linalg::Mat;

// The transpose of the inverse of L, L L^T = pI - A: false outside the domain.
template <int D>
bool inverse_root(const Mat<D>& matrix, Mat<D>& inverse) {
  Mat<D> L;
  if (!linalg::cholesky(matrix, L)) return false;
  inverse = transposed(linalg::inverse_of_lower(L));
  return true;
}

class ReciprocalBarrier final : public MultiplierPenalty {
 public:
  void set_multipliers(int, const Blocks& U) override {
    U_ = U;
    largest_ = 0;
    for (const double entry : U) largest_ = std::max(largest_, std::abs(entry));
  }
  // Twice the largest eigenvalue of A.
  double least_parameter(double min_eigenvalue) const override { return 2 * (bound - min_eigenvalue); }
  double stiffness() const override { return 2 * largest_ / parameter; }

  void evaluate(int dim, const Blocks& S, PenaltyState& state) const override {
    state.resize(S.size() / static_cast<std::size_t>(dim * dim), S.size());
    state.largest = 0;
    for (const double entry : S) state.largest = std::max(state.largest, std::abs(entry));
    dim == 2 ? fill<2>(S, state) : fill<3>(S, state);
  }

  std::vector<double> values(int dim, const Blocks& S) const override {
    return dim == 2 ? all_values<2>(S) : all_values<3>(S);
  }

 private:
  // L with L L^T = W.
  template <int D>
  bool root(const Blocks& S, std::size_t e, Mat<D>& L) const {
    Mat<D> matrix = linalg::from_rows<D>(S.data() + e * D * D);
    for (int i = 0; i < D; ++i) matrix[i][i] += parameter - bound;
    return inverse_root(matrix, L);
  }
  template <int D>
  double value(const Mat<D>& N, std::size_t e) const {
    double sum = 0;
    for (int i = 0; i < D; ++i)
      sum +=
          parameter * parameter * N[i][i] - parameter * U_[e * D * D + static_cast<std::size_t>(i * (D + 1))];
    return sum;
  }
  template <int D>
  Mat<D> pulled(const Mat<D>& L, std::size_t e) const {
    return transposed(L) * linalg::from_rows<D>(U_.data() + e * D * D) * L;
  }

  template <int D>
  std::vector<double> all_values(const Blocks& S) const {
    std::vector<double> result(S.size() / (D * D));
#pragma omp parallel for schedule(static) if (result.size() > assembly::least_parallel)
    for (std::size_t e = 0; e < result.size(); ++e) {
      Mat<D> L;
      result[e] = root(S, e, L) ? value(pulled(L, e), e) : std::numeric_limits<double>::infinity();
    }
    return result;
  }

  template <int D>
  void fill(const Blocks& S, PenaltyState& state) const {
    const std::size_t count = state.value.size();
    Blocks L(S.size()), N(S.size()), Q;
    for (std::size_t e = 0; e < count; ++e) {
      Mat<D> root_of_W{};
      root(S, e, root_of_W);
      const Mat<D> of_U = pulled(root_of_W, e), W_U_W = root_of_W * of_U * transposed(root_of_W);
      state.value[e] = value(of_U, e);
      state.curvature.active[e] = 1;
      for (std::size_t k = 0; k < D * D; ++k)
        state.multiplier[e * D * D + k] = parameter * parameter * W_U_W.m[k / D][k % D];
      to_rows(root_of_W, L.data() + e * D * D);
      to_rows(of_U, N.data() + e * D * D);
    }
    std::vector<double> n;
    block_eigen(D, N, n, &Q);
    for (std::size_t e = 0; e < count; ++e) {
      to_rows(linalg::from_rows<D>(L.data() + e * D * D) * linalg::from_rows<D>(Q.data() + e * D * D),
              state.curvature.Q.data() + e * D * D);
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t k = 0; k < D; ++k)
          state.curvature.h[(e * D + j) * D + k] =
              parameter * parameter * std::max(0.0, n[e * D + j] + n[e * D + k]);
    }
  }

  Blocks U_;
  double largest_ = 0;
};

}  // namespace

std::unique_ptr<MultiplierPenalty> reciprocal_penalty() {
  return std::make_unique<ReciprocalBarrier>();
}

void pennon(Workspace& work, const Options& options, Progress& progress, Vector& x) {
  multiplier_method(work, options, progress, x, *reciprocal_penalty());
}

}  // namespace isostretch::sdp_penalty

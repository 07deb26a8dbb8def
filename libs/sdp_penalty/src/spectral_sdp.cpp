// The augmented Lagrangian of Apkarian, Noll, Thevenet and Tuan (2004): with multipliers U = V V^T the term
// p tr phi(V^T A V / p), phi(t) = t + t^2/2 down to t = -1/2 and -log(-2t)/4 - 3/8 below. Where we deviate:
// in V the eigenvalues of U do not fall below a share of those at the start. Multipliers of a matrix that is
// long in the cone vanish, and the term with them; when it leaves the cone later on nothing would hold it
// back.
#include "methods.hpp"
#include "multiplier_method.hpp"
#include "scaling.hpp"

#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/linalg/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::sdp_penalty {
namespace {

using linalg::Mat;

constexpr double branch = -0.5, least_share = 0.1;

double phi(double t) {
  return t < branch ? -0.25 * std::log(-2 * t) - 0.375 : t + 0.5 * t * t;
}
double slope(double t) {
  return t < branch ? -0.25 / t : 1 + t;
}

// (phi'(a) - phi'(b)) / (a - b): the branches averaged by their lengths, never by subtracting slopes.
double slope_difference(double a, double b) {
  const auto log_part = [](double s, double t) { return 0.25 / (s * t); };
  if (a > b) std::swap(a, b);
  if (a >= branch) return 1;
  if (b < branch) return log_part(a, b);
  return (log_part(a, branch) * (branch - a) + (b - branch)) / (b - a);
}

class QuadraticLog final : public MultiplierPenalty {
 public:
  void set_multipliers(int dim, const Blocks& U) override {
    root_.resize(U.size());
    largest_ = 0;
    for (const double entry : U) largest_ = std::max(largest_, std::abs(entry));
    if (least_ == 0) least_ = least_share * largest_;
    dim == 2 ? take_roots<2>(U) : take_roots<3>(U);
  }
  double least_parameter(double) const override { return 0; }
  double stiffness() const override { return largest_ * largest_ / parameter; }

  void evaluate(int dim, const Blocks& S, PenaltyState& state) const override {
    std::vector<double> t;
    block_eigen(dim, scaled(dim, S), t, &state.curvature.Q);
    state.resize(t.size() / static_cast<std::size_t>(dim), S.size());
    state.largest = 0;
    for (const double entry : S) state.largest = std::max(state.largest, std::abs(entry));
    dim == 2 ? fill<2>(t, state) : fill<3>(t, state);
  }

  std::vector<double> values(int dim, const Blocks& S) const override {
    std::vector<double> t;
    block_eigen(dim, scaled(dim, S), t, nullptr);
    const auto d = static_cast<std::size_t>(dim);
    std::vector<double> result(t.size() / d, 0.0);
    for (std::size_t k = 0; k < t.size(); ++k) result[k / d] += parameter * phi(t[k]);
    return result;
  }

 private:
  template <int D>
  void take_roots(const Blocks& U) {
    std::vector<double> lambda;
    Blocks Q;
    block_eigen(D, U, lambda, &Q);
    for (std::size_t e = 0; e < lambda.size() / D; ++e) {
      Mat<D> V = linalg::from_rows<D>(Q.data() + e * D * D);
      for (int k = 0; k < D; ++k)
        for (int r = 0; r < D; ++r)
          V[r][k] *= std::sqrt(std::max(least_, lambda[e * D + static_cast<std::size_t>(k)]));
      to_rows(V, root_.data() + e * D * D);
    }
  }

  // V^T A V / p.
  Blocks scaled(int dim, const Blocks& S) const { return dim == 2 ? scaled<2>(S) : scaled<3>(S); }
  template <int D>
  Blocks scaled(const Blocks& S) const {
    Blocks result(S.size());
    const std::size_t count = S.size() / (D * D);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
    for (std::size_t e = 0; e < count; ++e) {
      const Mat<D> V = linalg::from_rows<D>(root_.data() + e * D * D);
      Mat<D> A = linalg::from_rows<D>(S.data() + e * D * D);
      A *= -1.0;
      for (int i = 0; i < D; ++i) A[i][i] += bound;
      Mat<D> B = transposed(V) * A * V;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) B[i][j] /= parameter;
      to_rows(B, result.data() + e * D * D);
    }
    return result;
  }

  template <int D>
  void fill(const std::vector<double>& t, PenaltyState& state) const {
    const std::size_t count = t.size() / D;
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
    for (std::size_t e = 0; e < count; ++e) {
      const double* at = t.data() + e * D;
      double* basis = state.curvature.Q.data() + e * D * D;
      const Mat<D> T = linalg::from_rows<D>(root_.data() + e * D * D) * linalg::from_rows<D>(basis);
      Mat<D> multiplier{}, h{};
      state.value[e] = 0;
      state.curvature.active[e] = 1;
      for (int k = 0; k < D; ++k) {
        state.value[e] += parameter * phi(at[k]);
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) multiplier[r][c] += slope(at[k]) * T[r][k] * T[c][k];
        for (int j = 0; j < D; ++j) h[j][k] = slope_difference(at[j], at[k]) / parameter;
      }
      to_rows(multiplier, state.multiplier.data() + e * D * D);
      to_rows(T, basis);
      to_rows(h, state.curvature.h.data() + e * D * D);
    }
  }

  Blocks root_;  // V
  double largest_ = 0, least_ = 0;
};

}  // namespace

std::unique_ptr<MultiplierPenalty> quadratic_log_penalty() {
  return std::make_unique<QuadraticLog>();
}

void spectral_sdp(Workspace& work, const Options& options, Progress& progress, Vector& x) {
  multiplier_method(work, options, progress, x, *quadratic_log_penalty());
}

}  // namespace isostretch::sdp_penalty

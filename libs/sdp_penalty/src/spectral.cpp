#include "spectral.hpp"

#include "scaling.hpp"

#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/linalg/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::sdp_penalty {
namespace {

using linalg::Mat;

double value_at(const SpectralPenalty& p, double y) {
  if (p.kind == Penalty::spline) {
    if (p.tau * y < -0.5) return 2 * p.tau * y * y - (std::log(0.5) + 0.5) / p.tau;
    return -std::log1p(p.tau * y) / p.tau;
  }
  if (y >= 0) return 0;
  return p.kind == Penalty::quadratic ? p.tau * y * y : -p.tau * y * y * y;
}

double slope_at(const SpectralPenalty& p, double y) {
  if (p.kind == Penalty::spline) return p.tau * y < -0.5 ? 4 * p.tau * y : -1 / (1 + p.tau * y);
  if (y >= 0) return 0;
  return p.kind == Penalty::quadratic ? 2 * p.tau * y : -3 * p.tau * y * y;
}

// (p'(a) - p'(b)) / (a - b) where both are on one branch; p'' for a = b. Never by subtracting slopes.
double smooth_difference(const SpectralPenalty& p, double a, double b) {
  if (p.kind == Penalty::quadratic) return a < 0 ? 2 * p.tau : 0.0;
  if (p.kind == Penalty::cubic) return a < 0 ? -3 * p.tau * (a + b) : 0.0;
  return p.tau * a < -0.5 ? 4 * p.tau : p.tau / ((1 + p.tau * a) * (1 + p.tau * b));
}

// The same anywhere: the part below the branch point and the part above, averaged by their lengths.
double slope_difference(const SpectralPenalty& p, double a, double b) {
  const double branch = p.kind == Penalty::spline ? -0.5 / p.tau : 0.0;
  if (a > b) std::swap(a, b);
  if ((a < branch) == (b < branch)) return smooth_difference(p, a, b);
  // Below the branch point up to it: the limit of the lower branch; from it on the upper one.
  double lower = 0;
  if (p.kind == Penalty::quadratic) lower = 2 * p.tau;
  if (p.kind == Penalty::cubic) lower = -3 * p.tau * a;
  if (p.kind == Penalty::spline) lower = 4 * p.tau;
  const double upper = smooth_difference(p, branch, b);
  return (lower * (branch - a) + upper * (b - branch)) / (b - a);
}

Blocks shifted(const SpectralPenalty& penalty, int dim, const Blocks& S) {
  Blocks result = S;
  const auto entries = static_cast<std::size_t>(dim * dim), diagonal = static_cast<std::size_t>(dim + 1);
  for (std::size_t k = 0; k < S.size(); ++k) {
    if (k % entries % diagonal == 0) result[k] -= penalty.offset;
    if (penalty.shift != nullptr) result[k] -= (*penalty.shift)[k];
  }
  return result;
}

template <int D>
void fill_state(const SpectralPenalty& penalty, const std::vector<double>& y, PenaltyState& state) {
  const std::size_t count = y.size() / D;
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t e = 0; e < count; ++e) {
    const double* at = y.data() + e * D;
    const bool active =
        penalty.kind == Penalty::spline || std::any_of(at, at + D, [](double v) { return v < 0; });
    state.curvature.active[e] = active;
    state.value[e] = 0;
    Mat<D> multiplier{}, h{};
    if (active) {
      const Mat<D> Q = linalg::from_rows<D>(state.curvature.Q.data() + e * D * D);
      for (int k = 0; k < D; ++k) {
        state.value[e] += value_at(penalty, at[k]);
        const double pull = -slope_at(penalty, at[k]);
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) multiplier[r][c] += pull * Q[r][k] * Q[c][k];
        for (int j = 0; j < D; ++j) h[j][k] = slope_difference(penalty, at[j], at[k]);
      }
    }
    to_rows(multiplier, state.multiplier.data() + e * D * D);
    to_rows(h, state.curvature.h.data() + e * D * D);
  }
}

}  // namespace

std::vector<double> values(const SpectralPenalty& penalty, int dim, const Blocks& S) {
  std::vector<double> y;
  block_eigen(dim, shifted(penalty, dim, S), y, nullptr);
  const auto d = static_cast<std::size_t>(dim);
  std::vector<double> result(y.size() / d, 0.0);
  for (std::size_t k = 0; k < y.size(); ++k) result[k / d] += value_at(penalty, y[k]);
  return result;
}

void evaluate(const SpectralPenalty& penalty, int dim, const Blocks& S, PenaltyState& state) {
  std::vector<double> y;
  block_eigen(dim, shifted(penalty, dim, S), y, &state.curvature.Q);
  const std::size_t count = y.size() / static_cast<std::size_t>(dim);
  state.resize(count, S.size());
  state.largest = 0;
  for (const double v : y) state.largest = std::max(state.largest, std::abs(v));
  if (dim == 2)
    fill_state<2>(penalty, y, state);
  else
    fill_state<3>(penalty, y, state);
}

}  // namespace isostretch::sdp_penalty

#include "cone.hpp"

#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/linalg/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace isostretch::sdp_penalty {
namespace {

using linalg::Mat;

// out_i = T_i A_i T_i^T, or with the transposes T_i^T A_i T_i.
template <int D>
Blocks congruence(const Blocks& T, const Blocks& A, bool transpose) {
  Blocks out(A.size());
  const std::size_t count = A.size() / (D * D);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t i = 0; i < count; ++i) {
    Mat<D> t = linalg::from_rows<D>(T.data() + i * D * D);
    if (transpose) t = transposed(t);
    to_rows(t * linalg::from_rows<D>(A.data() + i * D * D) * transposed(t), out.data() + i * D * D);
  }
  return out;
}

Blocks congruence(std::size_t size, const Blocks& T, const Blocks& A, bool transpose) {
  if (size == 2) return congruence<2>(T, A, transpose);
  if (size == 3) return congruence<3>(T, A, transpose);
  if (size == 4) return congruence<4>(T, A, transpose);
  return congruence<6>(T, A, transpose);
}

// Smallest eigenvalue of all diag(l)^-1/2 D_i diag(l)^-1/2.
double smallest_relative(std::size_t d, const std::vector<double>& l, const Blocks& D) {
  Blocks relative(D.size());
  std::vector<double> root(l.size());
  for (std::size_t k = 0; k < l.size(); ++k) root[k] = 1 / std::sqrt(l[k]);
  const std::size_t count = D.size() / (d * d);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t r = 0; r < d; ++r)
      for (std::size_t c = 0; c < d; ++c)
        relative[(i * d + r) * d + c] = D[(i * d + r) * d + c] * root[i * d + r] * root[i * d + c];
  std::vector<double> lambda;
  block_eigen(static_cast<int>(d), relative, lambda, nullptr);
  return *std::min_element(lambda.begin(), lambda.end());
}

// The same of 2x2 blocks, which are not worth a kernel.
double smallest_relative_2(const std::vector<double>& l, const Blocks& D) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < D.size() / 4; ++i) {
    const double a = D[4 * i] / l[2 * i], c = D[4 * i + 3] / l[2 * i + 1],
                 bb = D[4 * i + 1] * D[4 * i + 1] / (l[2 * i] * l[2 * i + 1]);
    smallest = std::min(smallest, 0.5 * (a + c) - std::sqrt(0.25 * (a - c) * (a - c) + bb));
  }
  return smallest;
}

// Largest t <= limit with diag(l) + t D_i positive semi-definite for all blocks D_i.
double largest_step(std::size_t d, const std::vector<double>& l, const Blocks& D, double limit) {
  const double smallest = d == 2 ? smallest_relative_2(l, D) : smallest_relative(d, l, D);
  return smallest < 0 ? std::min(limit, -1 / smallest) : limit;
}

}  // namespace

void Cone::start(Blocks M, double floor, double least, double complementarity) {
  M_ = std::move(M);
  floor_ = floor;
  std::vector<double> lambda;
  Blocks Q;
  block_eigen(static_cast<int>(size_), M_, lambda, &Q);
  Z_.assign(M_.size(), 0.0);
  Y_.assign(M_.size(), 0.0);
  for (std::size_t i = 0; i < lambda.size() / size_; ++i)
    for (std::size_t k = 0; k < size_; ++k) {
      const double z = std::max(lambda[i * size_ + k] - floor_, least);
      for (std::size_t r = 0; r < size_; ++r)
        for (std::size_t c = 0; c < size_; ++c) {
          const double qq = Q[at(i, r, k)] * Q[at(i, c, k)];
          Z_[at(i, r, c)] += z * qq;
          Y_[at(i, r, c)] += complementarity * qq / z;
        }
    }
}

// C with C_jk = 2 c_jk / (l_j + l_k), c = centre I - diag(l)^2 - sym(dZ dY).
void Cone::set_target(double centre, bool correct) {
  target_.assign(Z_.size(), 0.0);
  const std::size_t count = Z_.size() / (size_ * size_);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t r = 0; r < size_; ++r)
      for (std::size_t c = 0; c < size_; ++c) {
        const double lr = scaling_.l[i * size_ + r], lc = scaling_.l[i * size_ + c];
        double value = r == c ? centre - lr * lr : 0.0;
        for (std::size_t k = 0; correct && k < size_; ++k)
          value -= 0.5 * (dZ_[at(i, r, k)] * dY_[at(i, k, c)] + dY_[at(i, r, k)] * dZ_[at(i, k, c)]);
        target_[at(i, r, c)] = 2 * value / (lr + lc);
      }
}

// sym((diag(l) + step dZ) (diag(l) + step dY)).
Blocks Cone::products_at(double step) const {
  Blocks z = dZ_, y = dY_, products(dZ_.size());
  const std::size_t count = Z_.size() / (size_ * size_);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t r = 0; r < size_; ++r)
      for (std::size_t c = 0; c < size_; ++c) {
        const double l = r == c ? scaling_.l[i * size_ + r] : 0.0;
        z[at(i, r, c)] = l + step * z[at(i, r, c)];
        y[at(i, r, c)] = l + step * y[at(i, r, c)];
      }
    for (std::size_t r = 0; r < size_; ++r)
      for (std::size_t c = 0; c < size_; ++c) {
        double& sum = products[at(i, r, c)];
        for (std::size_t k = 0; k < size_; ++k)
          sum += 0.5 * (z[at(i, r, k)] * y[at(i, k, c)] + y[at(i, r, k)] * z[at(i, k, c)]);
      }
  }
  return products;
}

void Cone::recentre(double step, double centre) {
  std::vector<double> lambda;
  Blocks Q;
  block_eigen(static_cast<int>(size_), products_at(step), lambda, &Q);
  for (double& value : lambda)
    value = std::max(std::clamp(value, 0.1 * centre, 10 * centre) - value, -10 * centre);
  const std::size_t count = Z_.size() / (size_ * size_);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t r = 0; r < size_; ++r)
      for (std::size_t c = 0; c < size_; ++c) {
        double value = 0;
        for (std::size_t k = 0; k < size_; ++k)
          value += lambda[i * size_ + k] * Q[at(i, r, k)] * Q[at(i, c, k)];
        target_[at(i, r, c)] += 2 * value / (scaling_.l[i * size_ + r] + scaling_.l[i * size_ + c]);
      }
}

void Cone::keep_direction() {
  kept_dZ_ = dZ_;
  kept_dY_ = dY_;
  kept_change_Z_ = change_Z_;
}

void Cone::restore_direction() {
  dZ_.swap(kept_dZ_);
  dY_.swap(kept_dY_);
  change_Z_.swap(kept_change_Z_);
}

bool Cone::scale() {
  residual_.resize(Z_.size());
  for (std::size_t k = 0; k < Z_.size(); ++k) residual_[k] = M_[k] - Z_[k];
  for (std::size_t i = 0; i < Z_.size() / (size_ * size_); ++i)
    for (std::size_t k = 0; k < size_; ++k) residual_[at(i, k, k)] -= floor_;
  return scaling_.compute(static_cast<int>(size_), Z_, Y_);
}

Blocks Cone::dual_residual() const {
  Blocks scaled = congruence(size_, scaling_.inverse, residual_, false);
  for (std::size_t k = 0; k < scaled.size(); ++k) scaled[k] = target_[k] - scaled[k];
  Blocks result = congruence(size_, scaling_.inverse, scaled, true);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] += Y_[k];
  return result;
}

void Cone::set_direction(const Blocks& change_of_M) {
  change_Z_ = residual_;
  for (std::size_t k = 0; k < change_Z_.size(); ++k) change_Z_[k] += change_of_M[k];
  dZ_ = congruence(size_, scaling_.inverse, change_Z_, false);
  dY_.resize(dZ_.size());
  for (std::size_t k = 0; k < dZ_.size(); ++k) dY_[k] = target_[k] - dZ_[k];
}

double Cone::longest_step(double limit) const {
  return std::min(largest_step(size_, scaling_.l, dZ_, limit), largest_step(size_, scaling_.l, dY_, limit));
}

void Cone::advance(double step) {
  const Blocks change_Y = congruence(size_, scaling_.inverse, dY_, true);
  for (std::size_t k = 0; k < Z_.size(); ++k) {
    Z_[k] += step * change_Z_[k];
    Y_[k] += step * change_Y[k];
  }
}

double Cone::complementarity() const {
  return std::inner_product(Z_.begin(), Z_.end(), Y_.begin(), 0.0);
}

}  // namespace isostretch::sdp_penalty

#include "incomplete_cholesky.hpp"

#include "chunks.hpp"
#include "diagonal_blocks.hpp"
#include "vector_operations.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::sparse {

FactorResult IncompleteCholesky::analyze(const SymmetricMatrix&, const NodeSystem& system) {
  const BlockCsr<double>& A = system.matrix();
  chunk_ = chunk_starts(A.rows);
  lower_ = {};
  lower_.rows = lower_.columns = A.rows;
  lower_.height = lower_.width = A.height;
  source_.clear();
  for (std::size_t chunk = 0; chunk + 1 < chunk_.size(); ++chunk)
    for (int i = chunk_[chunk]; i < chunk_[chunk + 1]; ++i) {
      for (int k = A.start[i]; k < A.start[i + 1]; ++k)
        if (A.column[k] >= chunk_[chunk] && A.column[k] < i) {
          lower_.column.push_back(A.column[k]);
          source_.push_back(k);
        }
      lower_.start.push_back(static_cast<int>(lower_.column.size()));
    }
  lower_.resize_values();
  work_.resize(system.size());
  sums_.resize(system.size());
  shift_ = 0;
  return {};
}

FactorResult IncompleteCholesky::factorize(const NodeSystem& system, const Coordinates&) {
  const BlockCsr<double>& A = system.matrix();
  if (const int bad = indefinite_diagonal(A); bad >= 0)
    return not_positive_definite(system, bad, " of its diagonal block");
  constexpr double least = 1e-3, growth = 4, most = 1e6;
  mark_.assign(max_parts(), std::vector<int>(A.rows, -1));
  inverse_.resize(A.area() * A.rows);
  shift_ = shift_ > least ? shift_ / growth : 0;  // that of the matrix before is a good guess
  while (!with_size(A.height, [&](auto b) { return factorize_chunks<decltype(b)::value>(A); })) {
    shift_ = std::max(least, growth * shift_);
    if (!(shift_ < most)) return {FactorStatus::failed, -1, "incomplete Cholesky broke down"};
  }
  scale_ = largest_diagonal(A);
  lower_float_ = to_float(lower_, 1 / scale_);
  inverse_float_.resize(inverse_.size());
  for (std::size_t k = 0; k < inverse_.size(); ++k)
    inverse_float_[k] = static_cast<float>(scale_ * inverse_[k]);
  return {};
}

template <int B>
bool IncompleteCholesky::factorize_chunks(const BlockCsr<double>& A) {
  const int chunks = static_cast<int>(chunk_.size()) - 1;
  std::vector<char> done(chunks, 1);
  for_ranges(chunks, 1, [&](int begin, int end, int part) {
    for (int c = begin; c < end; ++c)
      for (int i = chunk_[c]; i < chunk_[c + 1] && done[c] != 0; ++i)
        done[c] = factorize_row<B>(A, i, mark_[part]) ? 1 : 0;
  });
  return std::find(done.begin(), done.end(), 0) == done.end();
}

// W_ik = A_ik - sum_j V_ij W_kj^T and D_i = A_ii - sum_k V_ik W_ik^T, where V_ij = W_ij D_j^-1.
template <int B>
bool IncompleteCholesky::factorize_row(const BlockCsr<double>& A, int i, std::vector<int>& mark) {
  constexpr int area = B * B, most = 64;
  double V[most][area];  // of the row's last entries, which is nearly always all of them
  const int begin = lower_.start[i], end = lower_.start[i + 1], kept = std::max(begin, end - most);
  const double* diagonal = A.block(A.find(i, i));
  double D[area];
  for (int e = 0; e < area; ++e) D[e] = diagonal[e];
  for (int r = 0; r < B; ++r) D[B * r + r] *= 1 + shift_;
  const auto subtract = [](double* C, const double* v, const double* w) {
    for (int r = 0; r < B; ++r)
      for (int c = 0; c < B; ++c)
        for (int m = 0; m < B; ++m) C[B * r + c] -= v[B * r + m] * w[B * c + m];
  };
  const auto times_inverse = [&](int k, double* v) {
    const double *w = lower_.block(k), *inverse = inverse_.data() + area * std::size_t(lower_.column[k]);
    for (int r = 0; r < B; ++r)
      for (int c = 0; c < B; ++c) {
        v[B * r + c] = 0;
        for (int m = 0; m < B; ++m) v[B * r + c] += w[B * r + m] * inverse[B * m + c];
      }
  };
  for (int k = begin; k < end; ++k) mark[lower_.column[k]] = k;
  for (int k = begin; k < end; ++k) {
    double* W = lower_.block(k);
    std::copy_n(A.block(source_[k]), area, W);
    const int other = lower_.column[k];
    for (int l = lower_.start[other]; l < lower_.start[other + 1]; ++l)
      if (const int j = mark[lower_.column[l]]; j >= kept) subtract(W, V[j - kept], lower_.block(l));
    double own[area];
    times_inverse(k, own);
    subtract(D, own, W);
    if (k >= kept) std::copy_n(own, area, V[k - kept]);
  }
  for (int k = begin; k < end; ++k) mark[lower_.column[k]] = -1;

  double* inverse = inverse_.data() + area * static_cast<std::size_t>(i);
  std::copy_n(D, area, inverse);
  if (invert(inverse, B) >= 0) return false;
  constexpr double smallest_pivot = 1e-5;
  for (int r = 0; r < B; ++r)
    if (!(inverse[B * r + r] * diagonal[B * r + r] * smallest_pivot < 1)) return false;
  return true;
}

template <int B>
void IncompleteCholesky::solve_chunk(int chunk) {
  const int begin = chunk_[chunk], end = chunk_[chunk + 1];
  float *x = work_.data(), *sums = sums_.data();
  const auto divide = [&](int i, const float* from, float* to) {
    const float* inverse = inverse_float_.data() + static_cast<std::size_t>(i) * B * B;
    for (int r = 0; r < B; ++r) {
      to[r] = 0;
      for (int c = 0; c < B; ++c) to[r] += inverse[B * r + c] * from[c];
    }
  };
  for (int i = begin; i < end; ++i) {
    float sum[B];
    for (int r = 0; r < B; ++r) {
      sum[r] = x[B * i + r];
      sums[B * i + r] = 0;
    }
    for (int k = lower_float_.start[i]; k < lower_float_.start[i + 1]; ++k) {
      const float *w = lower_float_.block(k), *v = x + B * lower_float_.column[k];
      for (int r = 0; r < B; ++r)
        for (int c = 0; c < B; ++c) sum[r] -= w[B * r + c] * v[c];
    }
    divide(i, sum, x + B * i);
  }
  for (int i = end - 1; i >= begin; --i) {
    float own[B];
    divide(i, sums + B * i, own);
    for (int r = 0; r < B; ++r) own[r] = x[B * i + r] -= own[r];
    for (int k = lower_float_.start[i]; k < lower_float_.start[i + 1]; ++k) {
      const float* w = lower_float_.block(k);
      float* v = sums + B * lower_float_.column[k];
      for (int r = 0; r < B; ++r)
        for (int c = 0; c < B; ++c) v[c] += w[B * r + c] * own[r];
    }
  }
}

void IncompleteCholesky::apply(const double* r, double* z) {
  const int size = static_cast<int>(work_.size());
  const double largest = max_magnitude(r, size);
  const double unit = largest > 0 ? largest : 1;
  for (int i = 0; i < size; ++i) work_[i] = static_cast<float>(r[i] / unit);
  with_size(lower_float_.height, [&](auto b) {
    for_ranges(static_cast<int>(chunk_.size()) - 1, 1, [&](int begin, int end, int) {
      for (int chunk = begin; chunk < end; ++chunk) solve_chunk<decltype(b)::value>(chunk);
    });
  });
  for (int i = 0; i < size; ++i) z[i] = unit / scale_ * static_cast<double>(work_[i]);
}

}  // namespace isostretch::sparse

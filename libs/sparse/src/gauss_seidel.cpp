#include "gauss_seidel.hpp"

#include "chunks.hpp"

#include <algorithm>
#include <cmath>

namespace isostretch::sparse {
namespace {

constexpr int least_rows = 512;

template <int B>
void subtract_product(float* sum, const float* a, const float* x) {
  for (int r = 0; r < B; ++r)
    for (int c = 0; c < B; ++c) sum[r] -= a[B * r + c] * x[c];
}

template <int B>
void assign_product(float* y, const float* a, const float* x) {
  for (int r = 0; r < B; ++r) {
    float sum = 0;
    for (int c = 0; c < B; ++c) sum += a[B * r + c] * x[c];
    y[r] = sum;
  }
}

double norm(const double* block, std::size_t area) {
  double sum = 0;
  for (std::size_t e = 0; e < area; ++e) sum += block[e] * block[e];
  return std::sqrt(sum);
}

}  // namespace

int GaussSeidel::setup(const BlockCsr<double>& A, double scale, std::vector<double>& inverse) {
  const int b = A.height;
  chunk_ = chunk_starts(A.rows);
  chunk_of_.resize(A.rows);
  for (std::size_t c = 0; c + 1 < chunk_.size(); ++c)
    std::fill(chunk_of_.begin() + chunk_[c], chunk_of_.begin() + chunk_[c + 1], static_cast<int>(c));
  inverse.resize(A.area() * A.rows);
  inverse_.resize(inverse.size());
  added_.assign(A.rows, 0);
  before_.resize(static_cast<std::size_t>(b) * A.rows);
  for (int i = 0; i < A.rows; ++i) {
    double added = 0, enlarged[36];
    double* own = inverse.data() + A.area() * i;
    for (int k = A.start[i]; k < A.start[i + 1]; ++k) {
      if (A.column[k] == i) std::copy_n(A.block(k), A.area(), own);
      if (chunk_of_[A.column[k]] != chunk_of_[i]) added += norm(A.block(k), A.area());
    }
    std::copy_n(own, A.area(), enlarged);
    for (int r = 0; r < b; ++r) enlarged[b * r + r] += added;
    added_[i] = static_cast<float>(added * scale);
    if (const int bad = invert(own, b); bad >= 0) return b * i + bad;
    invert(enlarged, b);
    for (std::size_t e = 0; e < A.area(); ++e)
      inverse_[A.area() * i + e] = static_cast<float>(enlarged[e] / scale);
  }
  return -1;
}

template <int B>
void GaussSeidel::forward_chunk(const BlockCsr<float>& A, const float* b, float* x, int chunk) const {
  const int first = chunk_[chunk];
  for (int i = first; i < chunk_[chunk + 1]; ++i) {
    float sum[B];
    std::copy_n(b + static_cast<std::size_t>(B) * i, B, sum);
    for (int k = A.start[i]; k < A.start[i + 1] && A.column[k] < i; ++k)
      if (A.column[k] >= first) subtract_product<B>(sum, A.block(k), x + B * A.column[k]);
    assign_product<B>(x + B * i, inverse_.data() + static_cast<std::size_t>(B) * B * i, sum);
  }
}

// Of b - A x the lower part within the chunk is zero by what forward_chunk() solved.
template <int B>
void GaussSeidel::residual_rows(const BlockCsr<float>& A, const float* x, float* r, int begin,
                                int end) const {
  for (int i = begin; i < end; ++i) {
    float sum[B];
    for (int e = 0; e < B; ++e) sum[e] = added_[i] * x[B * i + e];
    const int first = chunk_[chunk_of_[i]];
    for (int k = A.start[i]; k < A.start[i + 1]; ++k) {
      const int j = A.column[k];
      if (j < first || j > i) subtract_product<B>(sum, A.block(k), x + B * j);
    }
    std::copy_n(sum, B, r + static_cast<std::size_t>(B) * i);
  }
}

template <int B>
void GaussSeidel::backward_chunk(const BlockCsr<float>& A, const float* b, float* x, int chunk) const {
  const int first = chunk_[chunk], last = chunk_[chunk + 1] - 1;
  for (int i = last; i >= first; --i) {
    float sum[B], change[B];
    std::copy_n(b + static_cast<std::size_t>(B) * i, B, sum);
    for (int k = A.start[i]; k < A.start[i + 1]; ++k) {
      const int j = A.column[k];
      subtract_product<B>(sum, A.block(k), (j < first || j > last ? before_.data() : x) + B * j);
    }
    assign_product<B>(change, inverse_.data() + static_cast<std::size_t>(B) * B * i, sum);
    for (int e = 0; e < B; ++e) x[B * i + e] += change[e];
  }
}

void GaussSeidel::forward(const BlockCsr<float>& A, const float* b, float* x, float* r) const {
  with_size(A.height, [&](auto size) {
    constexpr int B = decltype(size)::value;
    for_ranges(static_cast<int>(chunk_.size()) - 1, 1, [&](int begin, int end, int) {
      for (int chunk = begin; chunk < end; ++chunk) forward_chunk<B>(A, b, x, chunk);
    });
    for_ranges(A.rows, least_rows, [&](int begin, int end, int) { residual_rows<B>(A, x, r, begin, end); });
  });
}

void GaussSeidel::backward(const BlockCsr<float>& A, const float* b, float* x) {
  std::copy_n(x, before_.size(), before_.begin());
  with_size(A.height, [&](auto size) {
    for_ranges(static_cast<int>(chunk_.size()) - 1, 1, [&](int begin, int end, int) {
      for (int chunk = begin; chunk < end; ++chunk) backward_chunk<decltype(size)::value>(A, b, x, chunk);
    });
  });
}

}  // namespace isostretch::sparse

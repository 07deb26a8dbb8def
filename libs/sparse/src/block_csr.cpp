#include "block_csr.hpp"

#include <isostretch/linalg/cholesky.hpp>

#include <algorithm>
#include <array>

namespace isostretch::sparse {
namespace {

constexpr int least_rows = 512;

template <int H, int W, bool add, class T>
void multiply_rows(const BlockCsr<T>& A, const T* x, T* y, int begin, int end) {
  for (int i = begin; i < end; ++i) {
    T sum[H] = {};
    for (int k = A.start[i]; k < A.start[i + 1]; ++k) {
      const T* a = A.value.data() + static_cast<std::size_t>(k) * (H * W);
      const T* v = x + static_cast<std::size_t>(A.column[k]) * W;
      for (int r = 0; r < H; ++r)
        for (int c = 0; c < W; ++c) sum[r] += a[W * r + c] * v[c];
    }
    T* out = y + static_cast<std::size_t>(i) * H;
    for (int r = 0; r < H; ++r) out[r] = add ? out[r] + sum[r] : sum[r];
  }
}

template <bool add, class T>
void multiply_any(const BlockCsr<T>& A, const T* x, T* y) {
  with_size(A.height, [&](auto h) {
    with_size(A.width, [&](auto w) {
      for_ranges(A.rows, least_rows, [&](int begin, int end, int) {
        multiply_rows<decltype(h)::value, decltype(w)::value, add>(A, x, y, begin, end);
      });
    });
  });
}

// Row by row (Gustavson 1978), first the pattern, then the values. `mark` says where a column stands in the
// row at hand.
class Product {
 public:
  Product(const BlockCsr<double>& A, const BlockCsr<double>& B)
      : A_(A), B_(B), marks_(max_parts(), std::vector<int>(B.columns, -1)) {
    C_.rows = A.rows;
    C_.columns = B.columns;
    C_.height = A.height;
    C_.width = B.width;
  }

  BlockCsr<double> compute() {
    C_.start.assign(A_.rows + 1, 0);
    for_ranges(A_.rows, least_rows, [&](int begin, int end, int part) { count(begin, end, marks_[part]); });
    for (int i = 0; i < A_.rows; ++i) C_.start[i + 1] += C_.start[i];
    C_.column.resize(C_.start.back());
    C_.resize_values();
    with_size(C_.height, [&](auto h) {
      with_size(A_.width, [&](auto w) {
        with_size(C_.width, [&](auto c) {
          for_ranges(A_.rows, least_rows, [&](int begin, int end, int part) {
            std::vector<int>& mark = marks_[part];
            std::fill(mark.begin(), mark.end(), -1);
            for (int i = begin; i < end; ++i) {
              list_columns(i, mark);
              add_row<decltype(h)::value, decltype(w)::value, decltype(c)::value>(i, mark);
            }
          });
        });
      });
    });
    return std::move(C_);
  }

 private:
  void count(int begin, int end, std::vector<int>& mark) {
    for (int i = begin; i < end; ++i)
      for (int k = A_.start[i]; k < A_.start[i + 1]; ++k)
        for (int l = B_.start[A_.column[k]]; l < B_.start[A_.column[k] + 1]; ++l)
          if (int& seen = mark[B_.column[l]]; seen != i) {
            seen = i;
            ++C_.start[i + 1];
          }
  }

  void list_columns(int i, std::vector<int>& mark) {
    int next = C_.start[i];
    for (int k = A_.start[i]; k < A_.start[i + 1]; ++k)
      for (int l = B_.start[A_.column[k]]; l < B_.start[A_.column[k] + 1]; ++l)
        if (int& seen = mark[B_.column[l]]; seen < C_.start[i]) {
          seen = next;
          C_.column[next++] = B_.column[l];
        }
    std::sort(C_.column.begin() + C_.start[i], C_.column.begin() + next);
    for (int k = C_.start[i]; k < next; ++k) mark[C_.column[k]] = k;
  }

  template <int H, int M, int W>
  void add_row(int i, const std::vector<int>& mark) {
    for (int k = A_.start[i]; k < A_.start[i + 1]; ++k) {
      const double* a = A_.block(k);
      for (int l = B_.start[A_.column[k]]; l < B_.start[A_.column[k] + 1]; ++l) {
        const double* b = B_.block(l);
        double* c = C_.block(mark[B_.column[l]]);
        for (int r = 0; r < H; ++r)
          for (int m = 0; m < M; ++m)
            for (int w = 0; w < W; ++w) c[W * r + w] += a[M * r + m] * b[W * m + w];
      }
    }
  }

  const BlockCsr<double>&A_, &B_;
  BlockCsr<double> C_;
  std::vector<std::vector<int>> marks_;
};

}  // namespace

template <class T>
int BlockCsr<T>::find(int i, int j) const {
  const auto begin = column.begin() + start[i], end = column.begin() + start[i + 1];
  const auto found = std::lower_bound(begin, end, j);
  return found != end && *found == j ? static_cast<int>(found - column.begin()) : -1;
}

template <class T>
void multiply(const BlockCsr<T>& A, const T* x, T* y) {
  multiply_any<false>(A, x, y);
}

template <class T>
void multiply_add(const BlockCsr<T>& A, const T* x, T* y) {
  multiply_any<true>(A, x, y);
}

template struct BlockCsr<double>;
template struct BlockCsr<float>;
template void multiply(const BlockCsr<double>&, const double*, double*);
template void multiply(const BlockCsr<float>&, const float*, float*);
template void multiply_add(const BlockCsr<float>&, const float*, float*);

BlockCsr<double> transpose(const BlockCsr<double>& A) {
  BlockCsr<double> T;
  T.rows = A.columns;
  T.columns = A.rows;
  T.height = A.width;
  T.width = A.height;
  T.start.assign(T.rows + 1, 0);
  for (const int j : A.column) ++T.start[j + 1];
  for (int i = 0; i < T.rows; ++i) T.start[i + 1] += T.start[i];
  T.column.resize(A.column.size());
  T.resize_values();
  std::vector<int> next = T.start;
  for (int i = 0; i < A.rows; ++i)
    for (int k = A.start[i]; k < A.start[i + 1]; ++k) {
      const int slot = next[A.column[k]]++;
      T.column[slot] = i;
      for (int r = 0; r < A.height; ++r)
        for (int c = 0; c < A.width; ++c) T.block(slot)[A.height * c + r] = A.block(k)[A.width * r + c];
    }
  return T;
}

BlockCsr<double> product(const BlockCsr<double>& A, const BlockCsr<double>& B) {
  return Product(A, B).compute();
}

BlockCsr<float> to_float(const BlockCsr<double>& A, double factor) {
  BlockCsr<float> F;
  F.rows = A.rows;
  F.columns = A.columns;
  F.height = A.height;
  F.width = A.width;
  F.start = A.start;
  F.column = A.column;
  F.resize_values();
  for (std::size_t k = 0; k < A.value.size(); ++k) F.value[k] = static_cast<float>(factor * A.value[k]);
  return F;
}

int cholesky(double* a, int n) {
  return linalg::cholesky(n, [a, n](int i, int j) -> double& { return a[j * n + i]; });
}

void cholesky_solve(const double* a, int n, double* z) {
  const auto factor = [a, n](int i, int j) { return a[j * n + i]; };
  const auto solution = [z](int i) -> double& { return z[i]; };
  linalg::solve_lower(n, factor, solution);
  linalg::solve_lower_transposed(n, factor, solution);
}

int invert(double* a, int n) {
  std::array<double, 36> factor{};
  std::copy(a, a + n * n, factor.begin());
  const int bad = cholesky(factor.data(), n);
  if (bad >= 0) return bad;
  for (int j = 0; j < n; ++j) {
    std::fill(a + j * n, a + (j + 1) * n, 0.0);
    a[j * n + j] = 1;
    cholesky_solve(factor.data(), n, a + j * n);
  }
  return -1;
}

}  // namespace isostretch::sparse

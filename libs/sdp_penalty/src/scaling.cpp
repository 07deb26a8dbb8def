#include "scaling.hpp"

#include <isostretch/assembly/least_parallel.hpp>
#include <isostretch/linalg/cholesky.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::sdp_penalty {
namespace {

using linalg::Mat;

// The kernels of linalg want entry e of block i at e * count + i, column by column.
struct Columns {
  std::size_t count, entries;
  std::vector<double> data;

  Columns(std::size_t blocks, std::size_t entries_each)
      : count(blocks), entries(entries_each), data(blocks * entries_each) {}
  double& operator()(std::size_t block, std::size_t entry) { return data[entry * count + block]; }
};

template <int D>
void put(const Mat<D>& A, Columns& columns, std::size_t block) {
  for (int r = 0; r < D; ++r)
    for (int c = 0; c < D; ++c) columns(block, static_cast<std::size_t>(r + D * c)) = A[r][c];
}

template <int D>
Mat<D> get(Columns& columns, std::size_t block) {
  Mat<D> A;
  for (int r = 0; r < D; ++r)
    for (int c = 0; c < D; ++c) A[r][c] = columns(block, static_cast<std::size_t>(r + D * c));
  return A;
}

constexpr std::size_t batch = 512;  // blocks a thread takes at once, small enough for its cache

// U and sigma of square matrices: entries of U row by row after one another, sigma in no order. The large
// ones by the eigenvectors of A A^T, which is near a multiple of the identity on the central path.
template <int D>
void left_vectors(const std::vector<Mat<D>>& A, std::vector<Mat<D>>& U, double* sigma) {
  const std::size_t count = A.size();
  U.resize(count);
  Columns matrices(count, D * D), vectors(count, D * D), values(count, D);
  for (std::size_t i = 0; i < count; ++i) put(D > 3 ? A[i] * transposed(A[i]) : A[i], matrices, i);
  if constexpr (D > 3)
    linalg::symmetric_eigen(D, {matrices.data.data(), values.data.data(), vectors.data.data(), count, count});
  else
    linalg::signed_svd(
        D, {matrices.data.data(), vectors.data.data(), values.data.data(), nullptr, count, count});
  for (std::size_t i = 0; i < count; ++i) {
    U[i] = get<D>(vectors, i);
    for (std::size_t k = 0; k < D; ++k) sigma[i * D + k] = D > 3 ? std::sqrt(values(i, k)) : values(i, k);
  }
}

// With Z = L L^T, Y = M M^T and M^T L = U diag(l) V^T:  r = L V diag(l)^-1/2,  r^-1 = diag(l)^-1/2 U^T M^T.
template <int D>
bool compute_scaling(const double* Z, const double* Y, std::size_t count, double* scaled_inverse,
                     double* weight, double* l) {
  constexpr std::size_t entries = D * D;
  std::vector<Mat<D>> Mt(count), product(count), U;
  bool positive = true;
  for (std::size_t i = 0; i < count; ++i) {
    Mat<D> L, M;
    positive = cholesky(linalg::from_rows<D>(Z + i * entries), L) && positive;
    positive = cholesky(linalg::from_rows<D>(Y + i * entries), M) && positive;
    Mt[i] = transposed(M);
    product[i] = Mt[i] * L;
  }
  if (!positive) return false;
  left_vectors<D>(product, U, l);
  for (std::size_t i = 0; i < count; ++i) {
    Mat<D> inverse = transposed(U[i]) * Mt[i];
    for (int k = 0; k < D; ++k) {
      const double lk = l[i * D + static_cast<std::size_t>(k)];
      positive = lk > 0 && positive;
      for (int c = 0; c < D; ++c) inverse[k][c] /= std::sqrt(lk);
    }
    to_rows(inverse, scaled_inverse + i * entries);
    to_rows(transposed(inverse) * inverse, weight + i * entries);
  }
  return positive;
}

template <int D>
bool compute_all_scalings(const std::vector<double>& Z, const std::vector<double>& Y, Scaling& scaling) {
  constexpr std::size_t entries = D * D;
  const std::size_t count = Z.size() / entries;
  scaling.inverse.resize(count * entries);
  scaling.weight.resize(count * entries);
  scaling.l.resize(count * D);
  std::vector<unsigned char> positive(count / batch + 1, 1);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t first = 0; first < count; first += batch)
    positive[first / batch] = compute_scaling<D>(
        &Z[first * entries], &Y[first * entries], std::min(batch, count - first),
        &scaling.inverse[first * entries], &scaling.weight[first * entries], &scaling.l[first * D]);
  return std::all_of(positive.begin(), positive.end(), [](unsigned char p) { return p != 0; });
}

template <int D>
void compute_eigen(const double* A, std::size_t count, double* lambda, double* Q) {
  constexpr std::size_t entries = D * D;
  Columns matrices(count, entries), vectors(Q ? count : 0, entries), values(count, D);
  for (std::size_t i = 0; i < count; ++i) put(linalg::from_rows<D>(A + i * entries), matrices, i);
  linalg::symmetric_eigen(
      D, {matrices.data.data(), values.data.data(), Q ? vectors.data.data() : nullptr, count, count});
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < D; ++k) lambda[i * D + k] = values(i, k);
    if (Q) to_rows(get<D>(vectors, i), Q + i * entries);
  }
}

template <int D>
void compute_all_eigen(const std::vector<double>& A, std::vector<double>& lambda, std::vector<double>* Q) {
  constexpr std::size_t entries = D * D;
  const std::size_t count = A.size() / entries;
  lambda.resize(count * D);
  if (Q) Q->resize(count * entries);
#pragma omp parallel for schedule(static) if (count > assembly::least_parallel)
  for (std::size_t first = 0; first < count; first += batch)
    compute_eigen<D>(A.data() + first * entries, std::min(batch, count - first), lambda.data() + first * D,
                     Q ? Q->data() + first * entries : nullptr);
}

}  // namespace

bool Scaling::compute(int size, const std::vector<double>& Z, const std::vector<double>& Y) {
  switch (size) {
    case 2:
      return compute_all_scalings<2>(Z, Y, *this);
    case 3:
      return compute_all_scalings<3>(Z, Y, *this);
    case 4:
      return compute_all_scalings<4>(Z, Y, *this);
    default:
      return compute_all_scalings<6>(Z, Y, *this);
  }
}

void block_eigen(int size, const std::vector<double>& A, std::vector<double>& lambda,
                 std::vector<double>* Q) {
  switch (size) {
    case 2:
      return compute_all_eigen<2>(A, lambda, Q);
    case 3:
      return compute_all_eigen<3>(A, lambda, Q);
    case 4:
      return compute_all_eigen<4>(A, lambda, Q);
    default:
      return compute_all_eigen<6>(A, lambda, Q);
  }
}

}  // namespace isostretch::sdp_penalty

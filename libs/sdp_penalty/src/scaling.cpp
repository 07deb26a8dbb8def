#include "scaling.hpp"

#include "small_matrix.hpp"

#include <isostretch/linalg/decompositions.hpp>

#include <cmath>

namespace isostretch::sdp_penalty {
namespace {

// The kernels of linalg want entry e of block i at e * count + i, column by column.
struct Columns {
  std::size_t count, entries;
  std::vector<double> data;

  Columns(std::size_t blocks, std::size_t entries_each)
      : count(blocks), entries(entries_each), data(blocks * entries_each) {}
  double& operator()(std::size_t block, std::size_t entry) { return data[entry * count + block]; }
};

template <int D>
void put(const Small<D>& A, Columns& columns, std::size_t block) {
  for (int r = 0; r < D; ++r)
    for (int c = 0; c < D; ++c) columns(block, static_cast<std::size_t>(r + D * c)) = A(r, c);
}

template <int D>
Small<D> get(Columns& columns, std::size_t block) {
  Small<D> A;
  for (int r = 0; r < D; ++r)
    for (int c = 0; c < D; ++c) A(r, c) = columns(block, static_cast<std::size_t>(r + D * c));
  return A;
}

// With Z = L L^T, Y = M M^T and M^T L = U diag(l) V^T:  r = L V diag(l)^-1/2,  r^-1 = diag(l)^-1/2 U^T M^T.
template <int D>
bool compute_scaling(const std::vector<double>& Z, const std::vector<double>& Y, Scaling& scaling) {
  constexpr std::size_t entries = D * D;
  const std::size_t count = Z.size() / entries;
  Columns product(count, entries), U(count, entries), sigma(count, D);
  std::vector<Small<D>> Mt(count);
  bool positive = true;
  for (std::size_t i = 0; i < count; ++i) {
    Small<D> L, M;
    positive = cholesky(load<D>(Z.data() + i * entries), L) && positive;
    positive = cholesky(load<D>(Y.data() + i * entries), M) && positive;
    Mt[i] = transposed(M);
    put(Mt[i] * L, product, i);
  }
  if (!positive) return false;
  linalg::signed_svd(D, {product.data.data(), U.data.data(), sigma.data.data(), nullptr, count, count});
  scaling.inverse.resize(count * entries);
  scaling.weight.resize(count * entries);
  scaling.l.resize(count * D);
  for (std::size_t i = 0; i < count; ++i) {
    Small<D> inverse = transposed(get<D>(U, i)) * Mt[i];
    for (int k = 0; k < D; ++k) {
      const double l = sigma(i, static_cast<std::size_t>(k));
      if (!(l > 0)) return false;
      scaling.l[i * D + static_cast<std::size_t>(k)] = l;
      for (int c = 0; c < D; ++c) inverse(k, c) /= std::sqrt(l);
    }
    store(inverse, scaling.inverse.data() + i * entries);
    store(transposed(inverse) * inverse, scaling.weight.data() + i * entries);
  }
  return true;
}

template <int D>
void compute_eigen(const std::vector<double>& A, std::vector<double>& lambda, std::vector<double>* Q) {
  constexpr std::size_t entries = D * D;
  const std::size_t count = A.size() / entries;
  Columns matrices(count, entries), vectors(count, entries), values(count, D);
  for (std::size_t i = 0; i < count; ++i) put(load<D>(A.data() + i * entries), matrices, i);
  linalg::symmetric_eigen(
      D, {matrices.data.data(), values.data.data(), Q ? vectors.data.data() : nullptr, count, count});
  lambda.resize(count * D);
  if (Q) Q->resize(count * entries);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < D; ++k) lambda[i * D + k] = values(i, k);
    if (Q) store(get<D>(vectors, i), Q->data() + i * entries);
  }
}

}  // namespace

bool Scaling::compute(int dim, const std::vector<double>& Z, const std::vector<double>& Y) {
  return dim == 2 ? compute_scaling<2>(Z, Y, *this) : compute_scaling<3>(Z, Y, *this);
}

void block_eigen(int dim, const std::vector<double>& A, std::vector<double>& lambda, std::vector<double>* Q) {
  if (dim == 2)
    compute_eigen<2>(A, lambda, Q);
  else
    compute_eigen<3>(A, lambda, Q);
}

}  // namespace isostretch::sdp_penalty

// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "kernel_table.hpp"

#include <isostretch/linalg/batches.hpp>
#include <isostretch/linalg/svd.hpp>
#include <isostretch/linalg/symmetric_eigen.hpp>

namespace isostretch::linalg {
namespace ISOSTRETCH_KERNELS {
namespace {

// Matrices of lanes i ... i + lanes - 1; lanes beyond the end of the batch repeat its last matrix.
template <int Entries>
struct Gather {
  const double* data;
  std::size_t stride, first, count;

  ISOSTRETCH_INLINE Pack operator()(int entry) const {
    const double* p = data + static_cast<std::size_t>(entry) * stride + first;
    if (first + lanes <= count) return load<Pack>(p);
    double buffer[lanes];
    for (std::size_t k = 0; k < lanes; ++k) buffer[k] = p[first + k < count ? k : count - 1 - first];
    return load<Pack>(buffer);
  }
};

ISOSTRETCH_INLINE void scatter(double* data, std::size_t stride, std::size_t first, std::size_t count,
                               int entry, Pack value) {
  double* p = data + static_cast<std::size_t>(entry) * stride + first;
  if (first + lanes <= count) return store(p, value);
  double buffer[lanes];
  store(buffer, value);
  for (std::size_t k = 0; first + k < count; ++k) p[k] = buffer[k];
}

template <int Dim>
ISOSTRETCH_INLINE Mat<Dim, Pack> gather_matrix(const double* data, std::size_t stride, std::size_t first,
                                               std::size_t count) {
  const Gather<Dim * Dim> entry{data, stride, first, count};
  Mat<Dim, Pack> M;
  for (int j = 0; j < Dim; ++j)
    for (int i = 0; i < Dim; ++i) M[i][j] = entry(i + Dim * j);
  return M;
}

template <int Dim>
ISOSTRETCH_INLINE void scatter_matrix(double* data, std::size_t stride, std::size_t first, std::size_t count,
                                      const Mat<Dim, Pack>& M) {
  if (data == nullptr) return;
  for (int j = 0; j < Dim; ++j)
    for (int i = 0; i < Dim; ++i) scatter(data, stride, first, count, i + Dim * j, M[i][j]);
}

template <int Dim>
ISOSTRETCH_INLINE void scatter_vector(double* data, std::size_t stride, std::size_t first, std::size_t count,
                                      const Pack (&v)[Dim]) {
  if (data == nullptr) return;
  for (int i = 0; i < Dim; ++i) scatter(data, stride, first, count, i, v[i]);
}

template <int Dim>
void svd_batch(const SvdBatch& batch) {
  for (std::size_t i = 0; i < batch.count; i += lanes) {
    Svd<Dim, Pack> svd;
    signed_svd(gather_matrix<Dim>(batch.F, batch.stride, i, batch.count), svd);
    scatter_matrix<Dim>(batch.U, batch.stride, i, batch.count, svd.U);
    scatter_vector<Dim>(batch.sigma, batch.stride, i, batch.count, svd.sigma);
    scatter_matrix<Dim>(batch.V, batch.stride, i, batch.count, svd.V);
  }
}

template <int Dim>
void polar_batch(const PolarBatch& batch) {
  for (std::size_t n = 0; n < batch.count; n += lanes) {
    Svd<Dim, Pack> svd;
    signed_svd(gather_matrix<Dim>(batch.F, batch.stride, n, batch.count), svd);
    Mat<Dim, Pack> R, S;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        Pack r = svd.U[i][0] * svd.V[j][0];
        Pack s = svd.V[i][0] * svd.sigma[0] * svd.V[j][0];
        for (int k = 1; k < Dim; ++k) {
          r = fma(svd.U[i][k], svd.V[j][k], r);
          s = fma(svd.V[i][k] * svd.sigma[k], svd.V[j][k], s);
        }
        R[i][j] = r;
        S[i][j] = s;
      }
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < i; ++j) S[j][i] = S[i][j];
    scatter_matrix<Dim>(batch.R, batch.stride, n, batch.count, R);
    scatter_matrix<Dim>(batch.S, batch.stride, n, batch.count, S);
  }
}

template <int Dim>
void eigen_batch(const EigenBatch& batch) {
  for (std::size_t n = 0; n < batch.count; n += lanes) {
    Mat<Dim, Pack> A = gather_matrix<Dim>(batch.A, batch.stride, n, batch.count);
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < i; ++j) A[j][i] = A[i][j];
    SymmetricEigen<Dim, Pack> eigen;
    symmetric_eigen(A, eigen);
    scatter_vector<Dim>(batch.lambda, batch.stride, n, batch.count, eigen.lambda);
    scatter_matrix<Dim>(batch.Q, batch.stride, n, batch.count, eigen.Q);
  }
}

}  // namespace

extern const DecompositionKernels decomposition_kernels;
const DecompositionKernels decomposition_kernels = {
    {svd_batch<2>, svd_batch<3>}, {polar_batch<2>, polar_batch<3>}, {eigen_batch<2>, eigen_batch<3>}};

}  // namespace ISOSTRETCH_KERNELS
}  // namespace isostretch::linalg

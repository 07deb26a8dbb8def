// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "kernel_table.hpp"

#include <isostretch/core/pack_pair.hpp>
#include <isostretch/linalg/batches.hpp>
#include <isostretch/linalg/svd.hpp>
#include <isostretch/linalg/symmetric_eigen.hpp>

namespace isostretch::linalg {
namespace ISOSTRETCH_KERNELS {
namespace {

// Entries of matrices first ... first + wide_lanes - 1; beyond the end of the batch the last matrix is
// repeated.
ISOSTRETCH_INLINE WidePack gather(const double* entry, std::size_t first, std::size_t count) {
  if (first + wide_lanes <= count) return load<WidePack>(entry + first);
  double buffer[wide_lanes];
  for (std::size_t k = 0; k < wide_lanes; ++k) buffer[k] = entry[first + k < count ? first + k : count - 1];
  return load<WidePack>(buffer);
}

ISOSTRETCH_INLINE void scatter(double* entry, std::size_t first, std::size_t count, WidePack value) {
  if (first + wide_lanes <= count) return store(entry + first, value);
  double buffer[wide_lanes];
  store(buffer, value);
  for (std::size_t k = 0; first + k < count; ++k) entry[first + k] = buffer[k];
}

template <int Dim>
ISOSTRETCH_INLINE Mat<Dim, WidePack> gather_matrix(const double* data, std::size_t stride, std::size_t first,
                                                   std::size_t count) {
  Mat<Dim, WidePack> M;
  for (int j = 0; j < Dim; ++j)
    for (int i = 0; i < Dim; ++i)
      M[i][j] = gather(data + static_cast<std::size_t>(i + Dim * j) * stride, first, count);
  return M;
}

template <int Dim>
ISOSTRETCH_INLINE void scatter_matrix(double* data, std::size_t stride, std::size_t first, std::size_t count,
                                      const Mat<Dim, WidePack>& M) {
  if (data == nullptr) return;
  for (int j = 0; j < Dim; ++j)
    for (int i = 0; i < Dim; ++i)
      scatter(data + static_cast<std::size_t>(i + Dim * j) * stride, first, count, M[i][j]);
}

template <int Dim>
ISOSTRETCH_INLINE void scatter_vector(double* data, std::size_t stride, std::size_t first, std::size_t count,
                                      const WidePack (&v)[Dim]) {
  if (data == nullptr) return;
  for (int i = 0; i < Dim; ++i) scatter(data + static_cast<std::size_t>(i) * stride, first, count, v[i]);
}

template <int Dim>
void svd_batch(const SvdBatch& batch) {
  for (std::size_t i = 0; i < batch.count; i += wide_lanes) {
    Svd<Dim, WidePack> svd;
    signed_svd(gather_matrix<Dim>(batch.F, batch.stride, i, batch.count), svd);
    scatter_matrix<Dim>(batch.U, batch.stride, i, batch.count, svd.U);
    scatter_vector<Dim>(batch.sigma, batch.stride, i, batch.count, svd.sigma);
    scatter_matrix<Dim>(batch.V, batch.stride, i, batch.count, svd.V);
  }
}

template <int Dim>
void polar_batch(const PolarBatch& batch) {
  for (std::size_t n = 0; n < batch.count; n += wide_lanes) {
    Svd<Dim, WidePack> svd;
    signed_svd(gather_matrix<Dim>(batch.F, batch.stride, n, batch.count), svd);
    Mat<Dim, WidePack> R, S;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        WidePack r = svd.U[i][0] * svd.V[j][0];
        WidePack s = svd.V[i][0] * svd.sigma[0] * svd.V[j][0];
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

template <int Dim, bool WithVectors>
void eigen_batch(const EigenBatch& batch) {
  for (std::size_t n = 0; n < batch.count; n += wide_lanes) {
    Mat<Dim, WidePack> A = gather_matrix<Dim>(batch.A, batch.stride, n, batch.count);
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < i; ++j) A[j][i] = A[i][j];
    SymmetricEigen<Dim, WidePack> eigen;
    symmetric_eigen<WithVectors>(A, eigen);
    scatter_vector<Dim>(batch.lambda, batch.stride, n, batch.count, eigen.lambda);
    if constexpr (WithVectors) scatter_matrix<Dim>(batch.Q, batch.stride, n, batch.count, eigen.Q);
  }
}

template <int Dim>
void eigen_batch(const EigenBatch& batch) {
  batch.Q == nullptr ? eigen_batch<Dim, false>(batch) : eigen_batch<Dim, true>(batch);
}

}  // namespace

extern const DecompositionKernels decomposition_kernels;
const DecompositionKernels decomposition_kernels = {
    {svd_batch<2>, svd_batch<3>},
    {polar_batch<2>, polar_batch<3>},
    {eigen_batch<2>, eigen_batch<3>, eigen_batch<4>, eigen_batch<6>}};

}  // namespace ISOSTRETCH_KERNELS
}  // namespace isostretch::linalg

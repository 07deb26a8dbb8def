// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "kernel_table.hpp"

#include <isostretch/projection/chunk_steps.hpp>

namespace isostretch::projection::ISOSTRETCH_KERNELS {
namespace {

template <int Dim>
void decompose_chunk(const PointChunk& chunk, const double* F, std::size_t f_stride) {
  for (int i = 0; i < chunk.count; i += wide_lanes)
    decompose<Dim, true>(load_matrix<Dim, WidePack>(F, f_stride, i), chunk, i);
}

// Stores block (c, d), c <= d, of a symmetric matrix of Nodes x Nodes blocks into its packed upper triangle.
template <int Dim, int Nodes>
ISOSTRETCH_INLINE void store_block(double* packed, std::size_t stride, int i, int c, int d,
                                   const Mat<Dim, Pack>& block) {
  constexpr int n = Dim * Nodes;
  for (int r = 0; r < Dim; ++r)
    for (int s = 0; s < Dim; ++s) {
      const int row = r + Dim * c, column = s + Dim * d;
      if (row > column) continue;
      const int e = row * n - row * (row - 1) / 2 + (column - row);
      store(packed + static_cast<std::size_t>(e) * stride + i, block[r][s]);
    }
}

// The Hessian over vec(F) is the block matrix of Dim nodes whose rest gradients are the unit vectors.
template <int Dim>
ISOSTRETCH_INLINE void store_hessian(const BlockCoefficients<Dim, Pack>& coefficients,
                                     const Mat<Dim, Pack>& U, const Mat<Dim, Pack>& V, double* H,
                                     std::size_t stride, int i) {
  for (int c = 0; c < Dim; ++c)
    for (int d = c; d < Dim; ++d)
      store_block<Dim, Dim>(H, stride, i, c, d, coefficients.block(U, V.m[c], V.m[d]));
}

ISOSTRETCH_INLINE Pack rest_gradient(const ChunkTask& task, int dim, int node, int axis, int i) {
  return load<Pack>(task.gradients + static_cast<std::size_t>((node - 1) * dim + axis) * task.stride + i);
}

// Linear elements: Dim + 1 nodes.
template <int Dim>
ISOSTRETCH_INLINE void store_element_gradient(const Mat<Dim, Pack>& P, const ChunkTask& task, int i) {
  for_each_force(
      Dim + 1, P, load<Pack>(task.weights + i),
      [&](int a, int c) { return rest_gradient(task, Dim, a, c, i); },
      [&](int a, int r, Pack value) {
        store(task.G + static_cast<std::size_t>(a * Dim + r) * task.stride + i, value);
      });
}

template <int Dim>
ISOSTRETCH_INLINE void store_element_hessian(const BlockCoefficients<Dim, Pack>& coefficients,
                                             const Mat<Dim, Pack>& U, const Mat<Dim, Pack>& V,
                                             const ChunkTask& task, int i) {
  Pack g[Dim + 1][Dim];
  for (int a = 1; a <= Dim; ++a) {
    Pack b[Dim];
    for (int c = 0; c < Dim; ++c) b[c] = rest_gradient(task, Dim, a, c, i);
    rotate_gradient(V, b, g[a]);
  }
  for_each_block(coefficients, U, g, [&](int a, int b, const Mat<Dim, Pack>& K) {
    store_block<Dim, Dim + 1>(task.K, task.stride, i, a, b, K);
  });
}

template <int Dim>
void finish_chunk(const PointChunk& chunk, const FilterOptions& filter, bool coupled, const ChunkTask& task) {
  for (int i = 0; i < chunk.count; i += lanes) {
    const Mat<Dim, Pack> U = load_matrix<Dim>(chunk.U, chunk.stride, i);
    const Mat<Dim, Pack> V = load_matrix<Dim>(chunk.V, chunk.stride, i);
    auto d = load_derivatives<Dim>(chunk.stretch, i);
    if (task.P != nullptr || task.G != nullptr) {
      const Mat<Dim, Pack> P = pk1(U, d.gradient, V);
      if (task.P != nullptr) store_matrix<Dim>(task.P, task.stride, i, P);
      if (task.G != nullptr) store_element_gradient<Dim>(P, task, i);
    }
    double flags[lanes];
    store(flags, select(apply_filter(filter, d, coupled), Pack(1.0), Pack(0.0)));
    for (int k = 0; k < lanes; ++k) task.changed[i + k] = flags[k] != 0.0;
    if (task.H != nullptr)
      store_hessian<Dim>(BlockCoefficients<Dim, Pack>(d, Pack(1.0)), U, V, task.H, task.stride, i);
    if (task.K != nullptr)
      store_element_hessian<Dim>(BlockCoefficients<Dim, Pack>(d, load<Pack>(task.weights + i)), U, V, task,
                                 i);
  }
}

}  // namespace

extern const ProjectionKernels projection_kernels;
const ProjectionKernels projection_kernels = {{decompose_chunk<2>, decompose_chunk<3>},
                                              {finish_chunk<2>, finish_chunk<3>}};

}  // namespace isostretch::projection::ISOSTRETCH_KERNELS

// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "kernel_table.hpp"

#include <isostretch/projection/chunk_steps.hpp>

namespace isostretch::projection::ISOSTRETCH_KERNELS {
namespace {

template <int Dim>
void decompose_chunk(const PointChunk& chunk) {
  for (int i = 0; i < chunk.count; i += lanes) decompose<Dim, true>(chunk, i);
}

// The Hessian over vec(F) is the block matrix of Dim nodes whose rest gradients are the unit vectors.
template <int Dim>
ISOSTRETCH_INLINE void store_hessian(const BlockCoefficients<Dim, Pack>& coefficients,
                                     const Mat<Dim, Pack>& U, const Mat<Dim, Pack>& V, double* H,
                                     std::size_t stride, int i) {
  constexpr int n = Dim * Dim;
  for (int c = 0; c < Dim; ++c)
    for (int d = c; d < Dim; ++d) {
      const Mat<Dim, Pack> block = coefficients.block(U, V.m[c], V.m[d]);
      for (int r = 0; r < Dim; ++r)
        for (int s = 0; s < Dim; ++s) {
          const int row = r + Dim * c, column = s + Dim * d;
          if (row > column) continue;
          const int packed = row * n - row * (row - 1) / 2 + (column - row);
          store(H + static_cast<std::size_t>(packed) * stride + i, block[r][s]);
        }
    }
}

template <int Dim>
void finish_chunk(const PointChunk& chunk, const FilterOptions& filter, bool coupled,
                  const ChunkOutputs& out) {
  for (int i = 0; i < chunk.count; i += lanes) {
    const Mat<Dim, Pack> U = load_matrix<Dim>(chunk.U, chunk.stride, i);
    const Mat<Dim, Pack> V = load_matrix<Dim>(chunk.V, chunk.stride, i);
    auto d = load_derivatives<Dim>(chunk.stretch, i);
    if (out.P != nullptr) store_matrix<Dim>(out.P, chunk.stride, i, pk1(U, d.gradient, V));
    const auto changed = apply_filter(filter, d, coupled);
    double flags[lanes];
    store(flags, select(changed, Pack(1.0), Pack(0.0)));
    for (int k = 0; k < lanes; ++k) out.changed[i + k] = flags[k] != 0.0;
    if (out.H != nullptr)
      store_hessian<Dim>(BlockCoefficients<Dim, Pack>(d, Pack(1.0)), U, V, out.H, chunk.stride, i);
  }
}

}  // namespace

extern const ProjectionKernels projection_kernels;
const ProjectionKernels projection_kernels = {{decompose_chunk<2>, decompose_chunk<3>},
                                              {finish_chunk<2>, finish_chunk<3>}};

}  // namespace isostretch::projection::ISOSTRETCH_KERNELS

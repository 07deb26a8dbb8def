// Compiled once per instruction-set level: see cmake/IsostretchKernels.cmake for what may be included here.
#include "kernel_table.hpp"

#include <isostretch/assembly/deformation_gradient.hpp>
#include <isostretch/projection/chunk_steps.hpp>

namespace isostretch::assembly::ISOSTRETCH_KERNELS {
namespace {

using projection::BlockCoefficients;
using projection::Mat;
using projection::PointChunk;

template <class T = Pack>
ISOSTRETCH_INLINE T entry(const double* data, std::size_t stride, int e, int i) {
  return load<T>(data + static_cast<std::size_t>(e) * stride + i);
}

ISOSTRETCH_INLINE void add_entry(double* data, std::size_t stride, int e, int i, Pack value) {
  double* p = data + static_cast<std::size_t>(e) * stride + i;
  store(p, load<Pack>(p) + value);
}

template <int Dim, int Nodes>
void gather(const ElementChunk& chunk, const double* x, double* X) {
  for (int a = 0; a < Nodes; ++a) {
    const int* node = chunk.nodes + static_cast<std::size_t>(a) * chunk.stride;
    for (int c = 0; c < Dim; ++c) {
      double* out = X + static_cast<std::size_t>(a * Dim + c) * chunk.stride;
      for (int i = 0; i < chunk.count; ++i)
        out[i] = x[static_cast<std::size_t>(node[i]) * Dim + static_cast<std::size_t>(c)];
    }
  }
}

template <int Dim, int Nodes, class T>
ISOSTRETCH_INLINE Mat<Dim, T> gradient_of(const ElementChunk& chunk, const double* X, int i) {
  return deformation_gradient<Dim, T>(
      Nodes, [&](int a, int r) { return entry<T>(X, chunk.stride, a * Dim + r, i); },
      [&](int a, int c) { return entry<T>(chunk.gradients, chunk.stride, a * Dim + c, i); });
}

template <int Dim, int Nodes>
void deform(const ElementChunk& chunk, const double* X, const PointChunk& points, bool vectors) {
  for (int i = 0; i < chunk.count; i += wide_lanes) {
    const auto F = gradient_of<Dim, Nodes, WidePack>(chunk, X, i);
    if (vectors)
      projection::decompose<Dim, true>(F, points, i);
    else
      projection::decompose<Dim, false>(F, points, i);
  }
}

// Index of block (a, b), a <= b, among the blocks of an element.
template <int Nodes>
ISOSTRETCH_INLINE constexpr int block_index(int a, int b) {
  return a * Nodes - a * (a - 1) / 2 + (b - a);
}

template <int Dim, int Nodes>
ISOSTRETCH_INLINE void add_hessian(const ElementChunk& chunk,
                                   const BlockCoefficients<Dim, Pack>& coefficients, const Mat<Dim, Pack>& U,
                                   const Mat<Dim, Pack>& V, double* H, int i) {
  Pack g[Nodes][Dim];
  for (int a = 1; a < Nodes; ++a) {
    Pack b[Dim];
    for (int c = 0; c < Dim; ++c) b[c] = entry(chunk.gradients, chunk.stride, a * Dim + c, i);
    projection::rotate_gradient(V, b, g[a]);
  }
  projection::for_each_block(coefficients, U, g, [&](int a, int b, const Mat<Dim, Pack>& K) {
    for (int r = 0; r < Dim; ++r)
      for (int s = 0; s < Dim; ++s)
        add_entry(H, chunk.stride, block_index<Nodes>(a, b) * Dim * Dim + r * Dim + s, i, K[r][s]);
  });
}

template <int Dim, int Nodes>
ISOSTRETCH_INLINE void add_gradient(const ElementChunk& chunk, const Mat<Dim, Pack>& P, Pack weight,
                                    double* G, int i) {
  projection::for_each_force(
      Nodes, P, weight, [&](int a, int c) { return entry(chunk.gradients, chunk.stride, a * Dim + c, i); },
      [&](int a, int r, Pack value) { add_entry(G, chunk.stride, a * Dim + r, i, value); });
}

// Filters where the chunk says so; the mask of points at which anything changed.
template <int Dim>
ISOSTRETCH_INLINE Mask<Pack> filter_points(const ElementChunk& chunk, const projection::FilterOptions& filter,
                                           bool coupled, int i,
                                           invariants::StretchDerivatives<Dim, Pack>& d) {
  const invariants::StretchDerivatives<Dim, Pack> exact = d;
  const Mask<Pack> changed = projection::apply_filter(filter, d, coupled);
  if (chunk.filtered == nullptr) return changed;
  const Mask<Pack> wanted = load<Pack>(chunk.filtered + i) > Pack(0.0);
  for (int e = 0; e < Dim; ++e) d.diagonal[e] = select(wanted, d.diagonal[e], exact.diagonal[e]);
  for (int e = 0; e < d.pairs; ++e) {
    d.twist[e] = select(wanted, d.twist[e], exact.twist[e]);
    d.flip[e] = select(wanted, d.flip[e], exact.flip[e]);
    d.coupling[e] = select(wanted, d.coupling[e], exact.coupling[e]);
  }
  return changed & wanted;
}

template <int Dim, int Nodes>
int differentiate(const ElementChunk& chunk, const PointChunk& points,
                  const projection::FilterOptions& filter, bool coupled, double* G, double* H) {
  int filtered = 0;
  for (int i = 0; i < chunk.count; i += lanes) {
    const Mat<Dim, Pack> U = projection::load_matrix<Dim>(points.U, points.stride, i);
    const Mat<Dim, Pack> V = projection::load_matrix<Dim>(points.V, points.stride, i);
    auto d = projection::load_derivatives<Dim>(points.stretch, i);
    const Pack weight = Pack(chunk.scale) * load<Pack>(chunk.weights + i);
    add_gradient<Dim, Nodes>(chunk, projection::pk1(U, d.gradient, V), weight, G, i);
    if (H == nullptr) continue;
    double changed[lanes];
    store(changed, select(filter_points<Dim>(chunk, filter, coupled, i, d), Pack(1.0), Pack(0.0)));
    for (int k = 0; k < lanes && i + k < chunk.real; ++k) filtered += changed[k] != 0.0;
    add_hessian<Dim, Nodes>(chunk, BlockCoefficients<Dim, Pack>(d, weight), U, V, H, i);
  }
  return filtered;
}

template <int Dim, int Nodes>
void determinant(const ElementChunk& chunk, const double* X, const double* DX, double* coefficients) {
  for (int i = 0; i < chunk.count; i += lanes) {
    const auto F = gradient_of<Dim, Nodes, Pack>(chunk, X, i),
               D = gradient_of<Dim, Nodes, Pack>(chunk, DX, i);
    const auto put = [&](int e, Pack value) {
      store(coefficients + static_cast<std::size_t>(e) * chunk.stride + i, value);
    };
    if constexpr (Dim == 2) {
      put(0, product_difference(F[0][0], F[1][1], F[0][1], F[1][0]));
      put(1, product_difference(F[0][0], D[1][1], F[0][1], D[1][0]) +
                 product_difference(D[0][0], F[1][1], D[0][1], F[1][0]));
      put(2, product_difference(D[0][0], D[1][1], D[0][1], D[1][0]));
    } else {
      const auto triple = [](const Mat<3, Pack>& A, const Mat<3, Pack>& B, const Mat<3, Pack>& C) {
        // Columns 0 of A, 1 of B, 2 of C.
        const Pack x = product_difference(B[1][1], C[2][2], B[2][1], C[1][2]);
        const Pack y = product_difference(B[2][1], C[0][2], B[0][1], C[2][2]);
        const Pack z = product_difference(B[0][1], C[1][2], B[1][1], C[0][2]);
        return fma(A[0][0], x, fma(A[1][0], y, A[2][0] * z));
      };
      put(0, triple(F, F, F));
      put(1, triple(D, F, F) + triple(F, D, F) + triple(F, F, D));
      put(2, triple(F, D, D) + triple(D, F, D) + triple(D, D, F));
      put(3, triple(D, D, D));
    }
  }
}

template <int Dim, int Nodes>
constexpr ElementKernels kernels_for() {
  return {Nodes, gather<Dim, Nodes>, deform<Dim, Nodes>, differentiate<Dim, Nodes>, determinant<Dim, Nodes>};
}

}  // namespace

extern const AssemblyKernels assembly_kernels;
const AssemblyKernels assembly_kernels = {{kernels_for<2, 3>(), kernels_for<2, 4>(), kernels_for<2, 6>()},
                                          {kernels_for<3, 4>(), kernels_for<3, 8>(), kernels_for<3, 10>()}};

}  // namespace isostretch::assembly::ISOSTRETCH_KERNELS

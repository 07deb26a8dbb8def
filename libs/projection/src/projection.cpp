#include "kernel_table.hpp"

#include <isostretch/core/arena.hpp>
#include <isostretch/core/dispatch.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/projection/point_chunk.hpp>
#include <isostretch/projection/projection.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace isostretch::projection {

ISOSTRETCH_DISPATCH(ProjectionKernels, projection_kernels)

namespace {

int packed_entries(int n) {
  return n * (n + 1) / 2;
}

// One array of the batch: how many entries a point has, and where they are.
struct Output {
  double* data;
  int entries;
};

// Scratch for one chunk: the pipeline's arrays, and space for the last chunk, which may not be full.
class Workspace {
 public:
  explicit Workspace(int dim)
      : memory_((point_chunk_doubles(dim) + static_cast<std::size_t>(chunk_size(dim)) * tail_entries(dim)) *
                sizeof(double)),
        chunk(bind_point_chunk(dim, memory_.doubles(point_chunk_doubles(dim)))) {}

  // `entries` arrays of the tail.
  double* take(int entries) { return memory_.doubles(static_cast<std::size_t>(entries) * chunk.stride); }

 private:
  static std::size_t tail_entries(int dim) {
    const int n = dim * dim, m = dim * (dim + 1);
    const int entries = n + n + packed_entries(n) + n + 1 + m + packed_entries(m);
    return static_cast<std::size_t>(entries);
  }

  Arena memory_;

 public:
  PointChunk chunk;
  std::array<unsigned char, chunk_size_2d> changed{};
};

// Where the entries of point `begin` start in an array of the batch; they are batch_stride() apart.
template <class T>
T* at(T* data, int entries, const HessianBatch& batch, std::size_t begin) {
  if (data == nullptr) return nullptr;
  if (batch.block == 0) return data + begin;
  return data + begin / batch.block * static_cast<std::size_t>(entries) * batch.block + begin % batch.block;
}

std::size_t batch_stride(const HessianBatch& batch) {
  return batch.block == 0 ? batch.stride : batch.block;
}

// The first points of an array, padded by repeating the last, in the tail.
const double* padded_copy(const double* data, std::size_t stride, std::size_t points, int entries,
                          Workspace& work) {
  if (data == nullptr) return nullptr;
  double* copy = work.take(entries);
  for (int e = 0; e < entries; ++e)
    for (std::size_t i = 0; i < static_cast<std::size_t>(work.chunk.count); ++i)
      copy[static_cast<std::size_t>(e) * work.chunk.stride + i] =
          data[static_cast<std::size_t>(e) * stride + std::min(i, points - 1)];
  return copy;
}

void copy_back(const Output& from, std::size_t from_stride, double* to, std::size_t to_stride,
               std::size_t points) {
  if (to == nullptr) return;
  for (int e = 0; e < from.entries; ++e)
    std::copy_n(from.data + static_cast<std::size_t>(e) * from_stride, points,
                to + static_cast<std::size_t>(e) * to_stride);
}

void mark_infinite(const double* psi, const Output& output, std::size_t stride, std::size_t points) {
  if (output.data == nullptr) return;
  for (std::size_t i = 0; i < points; ++i)
    if (!std::isfinite(psi[i]))
      for (int e = 0; e < output.entries; ++e)
        output.data[static_cast<std::size_t>(e) * stride + i] = std::numeric_limits<double>::quiet_NaN();
}

void require_valid(const energies::AnyEnergy& energy, int dim, const HessianBatch& batch) {
  if (dim != 2 && dim != 3)
    throw Error("deformation gradients are 2x2 or 3x3, not of dim " + std::to_string(dim));
  if (!energy.supports(dim))
    throw Error("energy '" + energy.name() + "' does not exist in " + std::to_string(dim) + "D");
  if (batch.block % chunk_size_2d != 0)
    throw Error("blocks of " + std::to_string(batch.block) + " points are not a multiple of " +
                std::to_string(chunk_size_2d));
  if (batch.block == 0 && batch.stride < batch.count)
    throw Error("batch of " + std::to_string(batch.count) + " points has a stride of only " +
                std::to_string(batch.stride));
  if ((batch.G != nullptr || batch.K != nullptr) && (batch.gradients == nullptr || batch.weights == nullptr))
    throw Error("element gradients and Hessians need rest gradients and weights");
}

}  // namespace

std::size_t evaluate(const energies::AnyEnergy& energy, int dim, const FilterOptions& filter,
                     const HessianBatch& batch) {
  require_valid(energy, dim, batch);
  const ProjectionKernels& kernels = active_projection_kernels();
  Workspace work(dim);
  PointChunk& chunk = work.chunk;
  const int n = dim * dim, m = dim * (dim + 1);
  std::size_t filtered = 0;
  for (std::size_t begin = 0; begin < batch.count; begin += chunk.stride) {
    const std::size_t points = std::min(batch.count - begin, chunk.stride);
    const bool full = points == chunk.stride;
    chunk.count = chunk.stretch.count = padded_count(static_cast<int>(points));
    // A full chunk is read and written in place, the last one through padded copies.
    const auto input = [&](const double* data, int entries) {
      const double* here = at(data, entries, batch, begin);
      return full ? here : padded_copy(here, batch_stride(batch), points, entries, work);
    };
    const auto output = [&](double* data, int entries) {
      double* here = at(data, entries, batch, begin);
      return Output{here == nullptr || full ? here : work.take(entries), entries};
    };
    const std::size_t stride = full ? batch_stride(batch) : chunk.stride;
    const double* F = input(batch.F, n);
    const double* gradients = input(batch.gradients, n);
    const double* weights = input(batch.weights, 1);
    const Output P = output(batch.P, n), H = output(batch.H, packed_entries(n)), G = output(batch.G, m),
                 K = output(batch.K, packed_entries(m));
    kernels.decompose[dim - 2](chunk, F, stride);
    energy.evaluate_derivatives(dim, chunk.stretch);
    kernels.finish[dim - 2](
        chunk, filter, energy.coupled(),
        {stride, P.data, H.data, G.data, K.data, gradients, weights, work.changed.data()});
    for (std::size_t i = 0; i < points; ++i) filtered += work.changed[i];
    const double* psi = chunk.stretch.psi;
    if (batch.psi != nullptr) std::copy_n(psi, points, batch.psi + begin);
    if (!std::all_of(psi, psi + points, [](double value) { return std::isfinite(value); }))
      for (const Output& out : {P, H, G, K}) mark_infinite(psi, out, stride, points);
    if (full) continue;
    const auto back = [&](const Output& out, double* data) {
      copy_back(out, stride, at(data, out.entries, batch, begin), batch_stride(batch), points);
    };
    back(P, batch.P);
    back(H, batch.H);
    back(G, batch.G);
    back(K, batch.K);
  }
  return filtered;
}

}  // namespace isostretch::projection

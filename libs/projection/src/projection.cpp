#include "kernel_table.hpp"

#include <isostretch/core/dispatch.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/projection/point_chunk.hpp>
#include <isostretch/projection/projection.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace isostretch::projection {

ISOSTRETCH_DISPATCH(ProjectionKernels, projection_kernels)

namespace {

struct Workspace {
  explicit Workspace(int dim)
      : memory(point_chunk_doubles(dim) +
               static_cast<std::size_t>(chunk_size(dim) * (dim * dim + packed_entries(dim)))),
        chunk(bind_point_chunk(dim, memory.data())),
        P(memory.data() + point_chunk_doubles(dim)),
        H(P + static_cast<std::size_t>(chunk_size(dim) * dim * dim)) {}

  static int packed_entries(int dim) { return dim * dim * (dim * dim + 1) / 2; }

  std::vector<double> memory;
  PointChunk chunk;
  double* P;
  double* H;
  std::array<unsigned char, chunk_size_2d> changed{};
};

// Copies `entries` arrays of `points` values between different strides.
void copy_points(const double* from, std::size_t from_stride, double* to, std::size_t to_stride, int entries,
                 std::size_t points) {
  for (int e = 0; e < entries; ++e)
    std::copy_n(from + static_cast<std::size_t>(e) * from_stride, points,
                to + static_cast<std::size_t>(e) * to_stride);
}

void load_points(int dim, const HessianBatch& batch, std::size_t begin, std::size_t points,
                 PointChunk& chunk) {
  copy_points(batch.F + begin, batch.stride, chunk.F, chunk.stride, dim * dim, points);
  chunk.count = static_cast<int>((points + 7) / 8 * 8);
  chunk.stretch.count = chunk.count;
  for (int e = 0; e < dim * dim; ++e)
    for (std::size_t i = points; i < static_cast<std::size_t>(chunk.count); ++i)
      chunk.F[static_cast<std::size_t>(e) * chunk.stride + i] = e % (dim + 1) == 0 ? 1.0 : 0.0;
}

void mark_infinite(const PointChunk& chunk, double* data, int entries, std::size_t points) {
  for (std::size_t i = 0; i < points; ++i)
    if (!std::isfinite(chunk.stretch.psi[i]))
      for (int e = 0; e < entries; ++e)
        data[static_cast<std::size_t>(e) * chunk.stride + i] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::size_t evaluate(const energies::AnyEnergy& energy, int dim, const FilterOptions& filter,
                     const HessianBatch& batch) {
  if (dim != 2 && dim != 3)
    throw Error("deformation gradients are 2x2 or 3x3, not of dim " + std::to_string(dim));
  if (!energy.supports(dim))
    throw Error("energy '" + energy.name() + "' does not exist in " + std::to_string(dim) + "D");
  const ProjectionKernels& kernels = active_projection_kernels();
  Workspace work(dim);
  const int packed = Workspace::packed_entries(dim);
  std::size_t filtered = 0;
  for (std::size_t begin = 0; begin < batch.count; begin += work.chunk.stride) {
    const std::size_t points = std::min(batch.count - begin, work.chunk.stride);
    load_points(dim, batch, begin, points, work.chunk);
    kernels.decompose[dim - 2](work.chunk);
    energy.evaluate_derivatives(dim, work.chunk.stretch);
    const ChunkOutputs out{batch.P ? work.P : nullptr, batch.H ? work.H : nullptr, work.changed.data()};
    kernels.finish[dim - 2](work.chunk, filter, energy.coupled(), out);
    for (std::size_t i = 0; i < points; ++i) filtered += work.changed[i];
    if (batch.psi)
      copy_points(work.chunk.stretch.psi, work.chunk.stride, batch.psi + begin, batch.stride, 1, points);
    if (batch.P) {
      mark_infinite(work.chunk, work.P, dim * dim, points);
      copy_points(work.P, work.chunk.stride, batch.P + begin, batch.stride, dim * dim, points);
    }
    if (batch.H) {
      mark_infinite(work.chunk, work.H, packed, points);
      copy_points(work.H, work.chunk.stride, batch.H + begin, batch.stride, packed, points);
    }
  }
  return filtered;
}

}  // namespace isostretch::projection

#include "kernel_table.hpp"

#include <isostretch/core/dispatch.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/linalg/batches.hpp>
#include <isostretch/linalg/decompositions.hpp>

#include <string>

namespace isostretch::linalg {

ISOSTRETCH_DISPATCH(DecompositionKernels, decomposition_kernels)

namespace {

void require_arrays(std::size_t count, std::size_t stride, const void* input) {
  if (stride < count)
    throw Error("batch of " + std::to_string(count) + " matrices has a stride of only " +
                std::to_string(stride));
  if (input == nullptr && count > 0) throw Error("batch without input matrices");
}

int index_of_two_or_three(int dim) {
  if (dim != 2 && dim != 3)
    throw Error("decompositions exist for 2x2 and 3x3 matrices, not for dim " + std::to_string(dim));
  return dim - 2;
}

int index_of_eigen(int dim) {
  if (dim < 2 || dim == 5 || dim > 6)
    throw Error("eigen-decompositions in batches exist for 2, 3, 4 and 6 rows, not for " +
                std::to_string(dim));
  return dim == 6 ? 3 : dim - 2;
}

}  // namespace

void signed_svd(int dim, const SvdBatch& batch) {
  const int index = index_of_two_or_three(dim);
  require_arrays(batch.count, batch.stride, batch.F);
  active_decomposition_kernels().svd[index](batch);
}

void polar(int dim, const PolarBatch& batch) {
  const int index = index_of_two_or_three(dim);
  require_arrays(batch.count, batch.stride, batch.F);
  active_decomposition_kernels().polar[index](batch);
}

void symmetric_eigen(int dim, const EigenBatch& batch) {
  const int index = index_of_eigen(dim);
  require_arrays(batch.count, batch.stride, batch.A);
  active_decomposition_kernels().eigen[index](batch);
}

}  // namespace isostretch::linalg

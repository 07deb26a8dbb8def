#include "assembler_kernels.hpp"

#include <isostretch/assembly/roots.hpp>
#include <isostretch/core/dispatch.hpp>
#include <isostretch/core/error.hpp>

#include <algorithm>
#include <string>

namespace isostretch::assembly {

ISOSTRETCH_DISPATCH(AssemblyKernels, assembly_kernels)

const ElementKernels& element_kernels(int dim, int nodes_per_element) {
  const AssemblyKernels& all = active_assembly_kernels();
  if (dim == 2) {
    for (const auto& kernels : all.planar)
      if (kernels.nodes == nodes_per_element) return kernels;
  } else {
    for (const auto& kernels : all.solid)
      if (kernels.nodes == nodes_per_element) return kernels;
  }
  throw Error("no kernels for elements of " + std::to_string(nodes_per_element) + " nodes in " +
              std::to_string(dim) + "D");
}

double determinant_step(int dim, const double* coefficients, std::size_t stride, double bound, double limit) {
  const double c0 = coefficients[0] - bound, c1 = coefficients[stride], c2 = coefficients[2 * stride];
  const double c3 = dim == 3 ? coefficients[3 * stride] : 0.0;
  // Most elements are far from flipping: all that goes down does not use up c0 before the limit.
  const double least =
      c0 + limit * (std::min(c1, 0.0) + limit * (std::min(c2, 0.0) + limit * std::min(c3, 0.0)));
  if (least > 0) return limit;
  const double root =
      dim == 2 ? smallest_positive_root_quadratic(c0, c1, c2) : smallest_positive_root_cubic(c0, c1, c2, c3);
  return std::min(limit, root);
}

}  // namespace isostretch::assembly

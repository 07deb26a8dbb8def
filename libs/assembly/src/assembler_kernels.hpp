#pragma once

#include "kernel_table.hpp"

namespace isostretch::assembly {

// Kernels of the active instruction-set level for elements of that kind.
const ElementKernels& element_kernels(int dim, int nodes_per_element);

// The largest t <= limit with det > bound on [0, t), given dim + 1 coefficients of det in t, `stride` apart.
double determinant_step(int dim, const double* coefficients, std::size_t stride, double bound, double limit);

}  // namespace isostretch::assembly

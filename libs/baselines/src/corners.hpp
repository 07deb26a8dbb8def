#pragma once

#include <isostretch/sdp_penalty/problem.hpp>

namespace isostretch::baselines {

// One linear element of a problem by its corners. F = sum_a x_a g_a^T, and the element's own unknowns are the
// entries of x_a in the order of corners: local entry dim * a + r.
struct Corners {
  Corners(const sdp_penalty::Problem& problem, int element)
      : dim(problem.dim()),
        node(problem.elements.nodes.data() + element * (dim + 1)),
        gradient(problem.elements.gradients.data() + element * (dim + 1) * dim),
        rotation(problem.rotations.data() + element * dim * dim) {}

  double g(int a, int c) const { return gradient[a * dim + c]; }
  double R(int r, int c) const { return rotation[r + dim * c]; }
  int dof(int a, int r) const { return node[a] * dim + r; }
  int dofs() const { return dim * (dim + 1); }

  // (R g_a)_r: what tr(R^T F) has for the entry r of x_a.
  double rotated_gradient(int a, int r) const {
    double sum = 0;
    for (int c = 0; c < dim; ++c) sum += R(r, c) * g(a, c);
    return sum;
  }
  // What entry (i, j) of S = sym(R^T F) has for the entry r of x_a.
  double constraint_coefficient(int i, int j, int a, int r) const {
    return 0.5 * (R(r, i) * g(a, j) + R(r, j) * g(a, i));
  }

  int dim;
  const int* node;
  const double* gradient;
  const double* rotation;
};

}  // namespace isostretch::baselines

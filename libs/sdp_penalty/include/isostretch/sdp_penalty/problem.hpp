#pragma once

#include <isostretch/assembly/elements.hpp>

#include <vector>

namespace isostretch::sdp_penalty {

// Node to bring to a position (dim entries), softly.
struct Target {
  int node = -1;
  std::vector<double> position;
};

// Inversion-free shape manipulation (Liu, Gao, Zhu, Sifakis, Kavan 2016): minimise over the positions x
//
//   sum_i w_i |F_i - R_i|^2 + kappa/2 sum_i (tr(R_i^T F_i) - dim)^2 + alpha sum_h |x_h - target_h|^2
//
// with S_i = sym(R_i^T F_i) >= margin I for every element (Eq. 1, 4 and 9): no element is inverted then. The
// ex-rotations R_i are given, hence the problem is convex and its solution unique.
struct Problem {
  assembly::Elements elements;    // linear: one quadrature point each; their weights are not used
  std::vector<double> rotations;  // [element][dim * dim] row by row, determinant 1
  std::vector<double> weights;    // w, one an element: see unit_weights() and volume_weights()
  std::vector<Target> targets;    // at least one
  double alpha = 1e4;             // as published; E_ex is free of units, the targets' term has length^2
  double incompressibility = 0;   // kappa
  double margin = 0;              // smallest eigenvalue that S_i may have

  int dim() const { return elements.dim; }
  int element_count() const { return elements.element_count(); }
  int node_count() const { return elements.node_count; }

  // Throws Error naming the element, target or entry that is out of range, not finite or no rotation.
  void validate() const;
};

// 1 for every element, as published: the elastic term then grows with the number of elements.
std::vector<double> unit_weights(const assembly::Elements& elements);
// Volumes over their mean: the same problem at every resolution, but for a factor of the whole.
std::vector<double> volume_weights(const assembly::Elements& elements);

}  // namespace isostretch::sdp_penalty

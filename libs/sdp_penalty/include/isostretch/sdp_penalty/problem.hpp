#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/core/vector.hpp>

#include <limits>
#include <vector>

namespace isostretch::sdp_penalty {

/// Node to bring to a position: softly, by the term with alpha, or to hold there.
struct Target {
  /// The node.
  int node = -1;
  std::vector<double> position;  ///< dim entries
  /// Whether the node is held there exactly.
  bool hard = false;
};

/// Inversion-free shape manipulation (Liu, Gao, Zhu, Sifakis, Kavan 2016): minimise over the positions x
///
///   sum_i w_i |F_i - R_i|^2 + kappa/2 sum_i (tr(R_i^T F_i) - dim)^2 + alpha sum_h |x_h - target_h|^2
///
/// (h: soft targets) with S_i = sym(R_i^T F_i) >= margin I for every element (Eq. 1, 4 and 9), so that
/// det F_i >= 0, and > 0 with a margin. The ex-rotations R_i are given, hence the problem is convex and its
/// solution unique.
struct Problem {
  assembly::Elements elements;    ///< linear: one quadrature point each; their weights are not used
  std::vector<double> rotations;  ///< [element][dim * dim] column by column, as vec(F) is
  std::vector<double> weights;    ///< w, one an element: see unit_weights() and volume_weights()
  std::vector<Target> targets;    ///< every component of the elements needs one that holds it
  /// Weight of soft targets, as published; the elastic term is free of units, that of targets has length^2.
  /// 0: soft targets do not count.
  double alpha = 1e4;
  double incompressibility = 0;  ///< kappa
  double margin = 0;             ///< smallest eigenvalue that S_i may have, and so the least stretch of F_i
  /// Largest singular value that F_i may have: with margin, bounded distortion (Lipman 2012; Kovalsky,
  /// Aigerman, Basri, Lipman 2014), as [[b I, F_i], [F_i^T, b I]] >= 0. Only the interior point knows it.
  double largest_stretch = std::numeric_limits<double>::infinity();

  /// Sets the ex-rotations from a range of one dim x dim matrix per element, of Eigen or of any type with
  /// matrix(row, column). That they are rotations is checked by validate().
  template <class Matrices>
  void set_rotations(const Matrices& matrices) {
    rotations.clear();
    for (const auto& R : matrices)
      for (int column = 0; column < dim(); ++column)
        for (int row = 0; row < dim(); ++row) rotations.push_back(R(row, column));
  }

  /// Returns whether largest_stretch is finite.
  bool bounds_stretch() const { return largest_stretch < std::numeric_limits<double>::infinity(); }
  /// Returns the dimension of the body, 2 or 3.
  int dim() const { return elements.dim; }
  /// Returns the number of elements.
  int element_count() const { return elements.element_count(); }
  /// Returns the number of nodes.
  int node_count() const { return elements.node_count; }

  /// Throws Error naming the element, target or entry that is out of range, not finite or no rotation, the
  /// node that two hard targets hold in different places, and a node of a component without a target.
  void validate() const;
};

/// Returns what is minimised, at x (dim entries a node).
double energy(const Problem& problem, const Vector& x);
/// Returns the part of energy() that soft targets have.
double target_energy(const Problem& problem, const Vector& x);

/// Returns 1 for every element, as published: the elastic term then grows with the number of elements.
std::vector<double> unit_weights(const assembly::Elements& elements);
/// Returns the volumes over their mean: the same problem at every resolution, but for a factor of the whole.
std::vector<double> volume_weights(const assembly::Elements& elements);

}  // namespace isostretch::sdp_penalty

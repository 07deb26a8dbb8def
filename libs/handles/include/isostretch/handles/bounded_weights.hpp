#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/handles/extension.hpp>
#include <isostretch/sparse/options.hpp>

#include <vector>

namespace isostretch::handles {

/// The choices of bounded_biharmonic_weights().
struct WeightOptions {
  /// The distance outside [0, 1] at which weights count as within and are set to the bound, between 1e-12 and
  /// 1e-3. A node held at a bound is let go when its gradient, over the diagonal of K M^-1 K, has the wrong
  /// sign by more than 1e-5 of this: small gradients of many nodes move the weights far.
  double tolerance = 1e-9;

  /// The largest number of linear systems per handle, at least 1; to need more is an Error.
  int max_iterations = 500;

  /// The linear solver; every system has another pattern, so one that factorises is meant.
  sparse::Options solver = factorizing();

  /// Throws Error naming the option that is out of range.
  void validate() const;
};

/// The course of the computation of one handle's weights.
struct WeightReport {
  /// Sets of held nodes that were tried, including that of the common start, which is empty.
  int iterations = 0;
  int factorizations = 0;  ///< Factorizations for this handle; the common start has one for all handles.
  bool descended = false;  ///< Whether a whole step would have raised the energy, and was shortened.
  int at_zero = 0;         ///< Nodes held at 0 by the bound, not by a handle.
  int at_one = 0;          ///< Nodes held at 1 by the bound, not by a handle.
  /// The residual of the optimality conditions: max |w - clip(w - g / diagonal)| with the gradient g = K M^-1
  /// K w, over all nodes that no handle holds, before rows are divided by their sums.
  double kkt_residual = 0;
};

/// The weight of every handle at every node.
struct HandleWeights {
  int handles = 0;             ///< Number of handles.
  std::vector<double> values;  ///< Weights, [node][handle], in [0, 1]; every row sums to 1.

  /// Nodes that no handle reaches, ascending: those of components without a node of any handle, and of no
  /// element. They have weight 1 of handle 0.
  std::vector<int> unreached;

  std::vector<WeightReport> reports;  ///< A report per handle.

  /// Returns the number of nodes.
  int node_count() const { return handles == 0 ? 0 : static_cast<int>(values.size()) / handles; }
  /// Returns the weight of a handle at a node.
  double at(int node, int handle) const {
    return values[static_cast<std::size_t>(node) * static_cast<std::size_t>(handles) +
                  static_cast<std::size_t>(handle)];
  }
};

/// Returns bounded biharmonic weights (Jacobson, Baran, Popovic, Sorkine 2011): for every handle the minimum
/// of 1/2 w^T K M^-1 K w with 0 <= w <= 1, w = 1 at its nodes and 0 at those of the other handles, K the
/// Laplacian and M the lumped mass of assembly/operators.hpp. Rows are then divided by their sums, as in the
/// paper's section 3, which drops the constraint that they sum to 1. handles[h] lists nodes, repetitions
/// allowed. A component that one handle alone reaches belongs to it.
///
/// The minimum is the exact one, found by projected Newton steps (Bertsekas 1982): systems with the nodes
/// held that the bounds hold. Which those are, sweeps of projected over-relaxation (Cryer 1971) find out
/// before every system, as in truncated nonsmooth Newton multigrid (Graeser, Kornhuber 2009). The energy
/// falls all the way. The end is a system whose solution is within the bounds while no bound holds a node the
/// wrong way, or, where rounding stands before that, a step that moves nothing; WeightReport::kkt_residual
/// tells.
///
/// Handles are solved in parallel, each with factorizations of its own: BLAS threads (OPENBLAS_NUM_THREADS)
/// only get in the way.
///
/// Throws Error when elements or options are invalid, there is no handle, a handle has no node, a node is out
/// of range or belongs to two handles, a system cannot be solved, or max_iterations do not suffice.
HandleWeights bounded_biharmonic_weights(const assembly::Elements& elements,
                                         const std::vector<std::vector<int>>& handles,
                                         const WeightOptions& options = {});

}  // namespace isostretch::handles

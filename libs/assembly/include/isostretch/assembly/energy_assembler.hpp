#pragma once

#include <isostretch/assembly/block_assembler.hpp>
#include <isostretch/assembly/elements.hpp>
#include <isostretch/assembly/hessian_pattern.hpp>
#include <isostretch/assembly/restriction.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/projection/filter.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace isostretch::assembly {

/// The value of an energy over all elements, and what was found on the way.
struct Evaluation {
  double value = 0;                 ///< Energy, +infinity outside its domain.
  int worst_element = -1;           ///< The first element whose psi is not finite, or -1.
  std::size_t points_filtered = 0;  ///< Quadrature points at which some eigenvalue was changed.
  std::size_t points = 0;           ///< Quadrature points.
};

/// The chunk loop: energy, gradient and filtered Hessian of sum weight * psi(F) over elements. Positions,
/// directions and gradients are vectors of node_count * dim entries, node by node. Parallel over chunks with
/// OpenMP; results are the same bit for bit for any number of threads, and allocate nothing after the first
/// call. What an energy throws reaches the caller: of several exceptions that of the first chunk of elements.
class EnergyAssembler {
 public:
  /// Throws Error when the elements are malformed or the energy does not exist in their dimension.
  EnergyAssembler(const Elements& elements, energies::AnyEnergy energy);

  /// Returns the dimension, 2 or 3.
  int dim() const { return dim_; }
  /// Returns the number of nodes.
  int node_count() const { return node_count_; }
  /// Returns the number of elements.
  int element_count() const { return element_count_; }
  /// Returns the number of quadrature points of all elements.
  std::size_t point_count() const {
    return static_cast<std::size_t>(element_count_) * static_cast<std::size_t>(points_);
  }
  /// Returns the energy.
  const energies::AnyEnergy& energy() const { return energy_; }
  /// Takes another energy from here on; elements and pattern stay. Throws Error when it does not exist in
  /// their dimension.
  void set_energy(energies::AnyEnergy energy);

  /// Multiplies all weights by a factor from here on, in place of the one before; it is 1 at first. Throws
  /// Error unless it is positive and finite.
  void set_scale(double scale);
  /// Returns the factor of all weights.
  double scale() const { return scale_; }

  /// Adds all pairs of nodes within an element to the pattern.
  void add_stencil(PatternBuilder& builder) const { restriction_.add_stencil(builder); }
  /// Prepares add_hessian() for a pattern that holds what add_stencil() added. The pattern must outlive this
  /// object where it is.
  void set_pattern(const HessianPattern& pattern);

  /// Returns the energy at positions x.
  Evaluation value(const double* x);

  /// Returns the energy at positions x, adds its gradient to `gradient` unless that is null, and prepares the
  /// Hessian, filtered, for add_hessian() where `hessian` asks for it. Where the value is infinite nothing is
  /// added.
  Evaluation differentiate(const double* x, const projection::FilterOptions& filter, double* gradient,
                           bool hessian);
  /// Adds the Hessian of the last differentiate() to the values of a matrix with the bound pattern.
  void add_hessian(double* values) const;

  /// Returns the first element, in the order of element_order(), to which the last differentiate() gave a
  /// gradient, or a Hessian where one was made, that is not finite; -1 if there is none. Costs a pass over
  /// all of them.
  int element_not_finite() const;

  /// Returns the blocks that add_hessian() adds, for approximations in the place of the Hessian: to be read
  /// and written after a differentiate() with the Hessian, or to be filled after one without. Those of
  /// element element_order()[i] are the blocks a <= b of its nodes, dim * dim entries each, row by row, from
  /// entry i * hessian_entries_per_element() on.
  double* element_hessians();
  /// Returns the number of entries of element_hessians() per element.
  std::size_t hessian_entries_per_element() const;
  /// Returns the caller's index of every element, in the order in which the chunks have them.
  const std::vector<int>& element_order() const { return original_; }

  /// Returns the largest t <= limit such that det(F + s dF) stays above the energy's bound for all 0 <= s < t
  /// at every quadrature point (Smith and Schaefer 2015); `limit` for energies without a barrier.
  double max_step(const double* x, const double* dx, double limit) const;

  /// Returns the singular values at the quadrature points, [element][point][dim].
  std::vector<double> stretches(const double* x) const;

 private:
  void order_elements(const Elements& elements);
  void chunk_elements(const Elements& elements);
  template <class Body>
  void for_each_chunk(const Body& body) const;
  template <class Kernels, class Work, class Body>
  void for_each_point(const Kernels& kernels, Work& work, int chunk, const Body& body) const;

  energies::AnyEnergy energy_;
  int dim_;
  int nodes_;
  int points_;
  int node_count_;
  int element_count_;
  int chunk_;
  int chunk_count_;
  double scale_ = 1;

  /// In chunks: [chunk][node][lane].
  std::vector<int> chunk_nodes_;
  /// [chunk][point][node * dim][lane]
  std::vector<double> chunk_gradients_;
  /// [chunk][point][lane]
  std::vector<double> chunk_weights_;

  std::vector<int> original_;             ///< Index of the caller, in the order of the chunks.
  Restriction restriction_;               ///< Over elements in the order of the chunks.
  std::optional<BlockAssembler> blocks_;  ///< For the bound pattern.
  std::vector<double> chunk_values_;
  std::vector<double> gradient_slots_;  ///< [element][node][dim]
  std::vector<double> hessian_slots_;   ///< [element][block a <= b][dim * dim]
};

}  // namespace isostretch::assembly

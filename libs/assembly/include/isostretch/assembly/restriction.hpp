#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/assembly/hessian_pattern.hpp>

#include <cstddef>
#include <vector>

namespace isostretch::assembly {

/// The linear map that says which nodes belong to which element: it takes values at nodes to values at the
/// corners of elements (a corner is a node as one element has it), and its transpose sums what corners hold
/// at their nodes.
class Restriction {
 public:
  /// Makes a map without elements, to be assigned to.
  Restriction() = default;
  /// Takes the nodes of the elements.
  explicit Restriction(const Elements& elements)
      : Restriction(elements.nodes, elements.nodes_per_element, elements.node_count) {}
  /// Takes nodes as [element][node], each in 0 ... node_count - 1. Sums run in the order of elements given
  /// here.
  Restriction(std::vector<int> nodes, int nodes_per_element, int node_count);

  /// Returns the number of nodes of each element.
  int nodes_per_element() const { return nodes_per_element_; }
  /// Returns the number of nodes.
  int node_count() const { return static_cast<int>(start_.size()) - 1; }
  /// Returns the number of elements.
  std::size_t element_count() const { return nodes_.size() / static_cast<std::size_t>(nodes_per_element_); }
  /// Returns the nodes of all elements, [element][node].
  const std::vector<int>& nodes() const { return nodes_; }
  /// Returns the nodes of an element.
  const int* nodes(std::size_t element) const {
    return nodes_.data() + element * static_cast<std::size_t>(nodes_per_element_);
  }

  /// Adds all pairs of nodes within an element to the pattern.
  void add_stencil(PatternBuilder& builder) const;

  /// Adds to the `dim` (2 or 3) entries of every node of x what the corners hold, [element][node][dim]. Runs
  /// in parallel, and gives the same bits for any number of threads: corners of a node are summed in the
  /// order of elements, and the sum is added.
  void add_transposed(int dim, const double* corners, double* x) const;

 private:
  template <int Dim>
  void add_sums(const double* corners, double* x) const;

  int nodes_per_element_ = 1;
  std::vector<int> nodes_;
  std::vector<std::size_t> start_{0};  ///< First entry of every node in corner_.
  std::vector<std::size_t> corner_;
};

}  // namespace isostretch::assembly

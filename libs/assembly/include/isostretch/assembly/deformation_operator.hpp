#pragma once

#include <isostretch/assembly/deformation_gradient.hpp>
#include <isostretch/assembly/elements.hpp>
#include <isostretch/projection/blocks.hpp>

#include <cstddef>
#include <vector>

namespace isostretch::assembly {
inline namespace ISOSTRETCH_ISA {

/// The linear map from positions, Dim entries per node, to the deformation gradients at the quadrature points
/// of elements, and its transpose. Points are counted over all elements: point p of element e is number e *
/// points_per_element + p. The arrays of the elements must outlive the operator where they are. Loops over
/// Nodes nodes of an element are unrolled; Nodes = 0 takes any elements.
template <int Dim, int Nodes = 0>
class DeformationOperator {
 public:
  /// Refers to the arrays of the elements.
  explicit DeformationOperator(const Elements& elements)
      : nodes_per_element_(static_cast<std::size_t>(elements.nodes_per_element)),
        points_per_element_(static_cast<std::size_t>(elements.points_per_element)),
        nodes_(elements.nodes.data()),
        gradients_(elements.gradients.data()) {}

  /// Returns the nodes of the element that a point belongs to.
  const int* nodes(std::size_t point) const {
    const std::size_t element = points_per_element_ == 1 ? point : point / points_per_element_;
    return nodes_ + element * nodes_per_element_;
  }

  /// Returns the rest gradients at a point, Dim entries per node of the element.
  const double* rest_gradients(std::size_t point) const {
    return gradients_ + point * nodes_per_element_ * Dim;
  }

  /// Returns F at a point for positions x.
  linalg::Mat<Dim> apply(std::size_t point, const double* x) const {
    const int* node = nodes(point);
    const double* g = rest_gradients(point);
    return deformation_gradient<Dim, double>(
        node_count(), [&](int a, int r) { return x[Dim * node[a] + r]; },
        [&](int a, int c) { return g[Dim * a + c]; });
  }

  /// Calls sink(a, r, value) with entry r of P g_a for every node a of a point's element: the derivative over
  /// node positions that belongs to a derivative P over F at the point.
  template <class Sink>
  void apply_transposed(std::size_t point, const linalg::Mat<Dim>& P, const Sink& sink) const {
    const double* g = rest_gradients(point);
    projection::for_each_force(
        node_count(), P, 1.0, [&](int a, int c) { return g[Dim * a + c]; }, sink);
  }

 private:
  int node_count() const { return Nodes > 0 ? Nodes : static_cast<int>(nodes_per_element_); }

  std::size_t nodes_per_element_, points_per_element_;
  const int* nodes_;
  const double* gradients_;
};

}  // namespace ISOSTRETCH_ISA

/// Computes F at the quadrature points first ... first + count - 1 for positions x, in the layout of the
/// batches of linalg: entry (r, c) of point first + i is at F[(r + dim * c) * stride + i].
void deformation_gradients(const Elements& elements, const double* x, std::size_t first, std::size_t count,
                           double* F, std::size_t stride);

/// Returns det F at every quadrature point, [element][point], for positions x. It is computed from the
/// entries of F: the product of singular values would lose the digits of small ones.
std::vector<double> determinants(const Elements& elements, const double* x);

}  // namespace isostretch::assembly

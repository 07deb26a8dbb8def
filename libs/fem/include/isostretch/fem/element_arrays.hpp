#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// The rest shape of a mesh as plain arrays: all that an assembly needs. The deformation gradient at a
/// quadrature point is F = sum over nodes of x_node * gradient^T.
struct ElementArrays {
  int dim = 0;                 ///< Dimension, 2 or 3.
  int nodes_per_element = 0;   ///< Nodes of each element.
  int points_per_element = 0;  ///< Quadrature points of each element; one for linear elements.
  int node_count = 0;          ///< Nodes of the mesh.
  std::vector<int> nodes;      ///< Indices of nodes, [element][node].
  /// Rest gradients of the shape functions, [element][point][node][dim], in 1 / length.
  std::vector<double> gradients;
  std::vector<double> weights;  ///< Rest areas or volumes, [element][point], positive.

  /// Returns the number of elements.
  int element_count() const {
    return nodes_per_element == 0 ? 0 : static_cast<int>(nodes.size()) / nodes_per_element;
  }
};

// All of these throw Error naming the element and its vertices when an index is out of range, a coordinate is
// not finite, or an element is degenerate: height below 1e-15 of the longest edge. Thinner-than-usual
// elements above that keep their accuracy: nothing is computed as a difference of large numbers.

/// Returns linear elements (dim = 2) for every triangle of a surface, laid isometrically in a plane of its
/// own: x axis along its longest edge, counter-clockwise. The frames of different triangles are unrelated,
/// which an isotropic energy does not notice. Throws Error naming the triangle and its vertices when an index
/// is out of range, a coordinate is not finite, or the triangle is degenerate.
ElementArrays flat_elements(const SurfaceMesh& mesh);

/// Returns linear triangles whose rest shape is in the plane. Throws Error naming the triangle and its
/// vertices when an index is out of range, a coordinate is not finite, or the triangle is degenerate or
/// clockwise.
ElementArrays elements(const Points2& vertices, const Triangles& triangles);

/// Returns linear tetrahedra (dim = 3). Throws Error naming the element and its vertices when an index is out
/// of range, a coordinate is not finite, or the element is degenerate or inverted.
ElementArrays elements(const TetMesh& mesh);

/// Returns the sum of the areas of all triangles.
double total_area(const SurfaceMesh& mesh);
/// Returns the rest area or volume of all elements.
double total_weight(const ElementArrays& elements);

/// Scales the rest shape uniformly so that the total area (volume) is `target`, and returns the factor of
/// lengths.
double scale_to_total_weight(ElementArrays& elements, double target = 1);

}  // namespace isostretch::mesh

#pragma once

#include <utility>
#include <vector>

namespace isostretch::assembly {

/// Elements as plain arrays of quadrature points: all that assembly ever knows of a mesh. The deformation
/// gradient at a point is F = sum over nodes of x_node * gradient^T, and the energy the sum over points of
/// weight * psi(F).
struct Elements {
  int dim = 0;                 ///< Dimension, 2 or 3.
  int nodes_per_element = 0;   ///< Nodes of each element: 3, 4 or 6 in 2D; 4, 8 or 10 in 3D.
  int points_per_element = 0;  ///< Quadrature points of each element.
  int node_count = 0;          ///< Nodes of the mesh.
  std::vector<int> nodes;      ///< Indices of nodes, [element][node].
  /// Rest gradients of the shape functions, [element][point][node][dim], in 1 / length.
  std::vector<double> gradients;
  std::vector<double> weights;  ///< Rest areas or volumes, [element][point].

  /// Returns the number of elements.
  int element_count() const {
    return nodes_per_element ? static_cast<int>(nodes.size()) / nodes_per_element : 0;
  }

  /// Throws Error naming the element unless array sizes fit, node indices are in range, numbers are finite,
  /// weights are positive, and gradients add up to zero over the nodes of an element: translations cost no
  /// energy, and assembly relies on it.
  void validate() const;
};

/// Returns the component of every node, counted from 0 by smallest node; -1 for a node of no element.
/// Elements that share a node belong together.
std::vector<int> component_of_nodes(const Elements& elements);

/// Returns elements from any struct with the same members, such as mesh::ElementArrays.
template <class Arrays>
Elements elements_from(Arrays arrays) {
  Elements e;
  e.dim = arrays.dim;
  e.nodes_per_element = arrays.nodes_per_element;
  e.points_per_element = arrays.points_per_element;
  e.node_count = arrays.node_count;
  e.nodes = std::move(arrays.nodes);
  e.gradients = std::move(arrays.gradients);
  e.weights = std::move(arrays.weights);
  return e;
}

}  // namespace isostretch::assembly

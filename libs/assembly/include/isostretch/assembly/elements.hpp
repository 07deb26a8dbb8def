#pragma once

#include <utility>
#include <vector>

namespace isostretch::assembly {

/// Elements as plain arrays of quadrature points: all that assembly ever knows of a mesh. The deformation
/// gradient at a point is F = sum over nodes of x_node * gradient^T, and the energy sum over points of weight
/// * psi(F).
struct Elements {
  int dim = 0;                 ///< 2 or 3
  int nodes_per_element = 0;   ///< 3, 4 or 6 in 2D; 4, 8 or 10 in 3D
  int points_per_element = 0;  ///< quadrature points
  int node_count = 0;
  std::vector<int> nodes;         ///< [element][node]
  std::vector<double> gradients;  ///< [element][point][node][dim], rest gradients of the shape functions
  std::vector<double> weights;    ///< [element][point], rest area or volume

  int element_count() const {
    return nodes_per_element ? static_cast<int>(nodes.size()) / nodes_per_element : 0;
  }

  /// Throws Error naming the element: array sizes, node indices in range, finite numbers, positive weights,
  /// and gradients that add up to zero over the nodes of an element (translations cost no energy; assembly
  /// relies on it).
  void validate() const;
};

/// Component of every node, counted from 0 by smallest node; -1 for a node of no element. Elements that share
/// a node belong together.
std::vector<int> component_of_nodes(const Elements& elements);

/// From any struct with the same members, mesh::ElementArrays for one.
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

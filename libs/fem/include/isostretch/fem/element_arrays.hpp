#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// Rest shape of a mesh as plain arrays, all that an assembly needs. The deformation gradient at a quadrature
/// point is F = sum over nodes of x_node * gradient^T.
struct ElementArrays {
  int dim = 0;
  int nodes_per_element = 0;
  int points_per_element = 0;  ///< quadrature points; one for linear elements
  int node_count = 0;
  std::vector<int> nodes;  ///< [element][node]
  std::vector<double>
      gradients;  ///< [element][point][node][dim]: rest gradients of the hat functions, 1 / length
  std::vector<double> weights;  ///< [element][point]: rest area or volume, positive

  int element_count() const {
    return nodes_per_element == 0 ? 0 : static_cast<int>(nodes.size()) / nodes_per_element;
  }
};

// All of these throw Error naming the element and its vertices when an index is out of range, a coordinate is
// not finite, or an element is degenerate: height below 1e-15 of the longest edge. Thinner-than-usual
// elements above that keep their accuracy: nothing is computed as a difference of large numbers.

/// Every triangle laid isometrically in a plane of its own (dim = 2): x axis along its longest edge,
/// counter-clockwise. The frames of different triangles are unrelated, which an isotropic energy does not
/// notice.
ElementArrays flat_elements(const SurfaceMesh& mesh);

/// Triangles with a rest shape in the plane; clockwise ones are refused too.
ElementArrays elements(const Points2& vertices, const Triangles& triangles);

/// Linear tetrahedra (dim = 3); inverted ones are refused too.
ElementArrays elements(const TetMesh& mesh);

double total_area(const SurfaceMesh& mesh);
double total_weight(const ElementArrays& elements);

/// Scales the rest shape uniformly so that the total area (volume) is `target`; returns the factor of
/// lengths.
double scale_to_total_weight(ElementArrays& elements, double target = 1);

}  // namespace isostretch::mesh

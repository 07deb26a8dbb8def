#pragma once

#include <isostretch/mesh/shape.hpp>
#include <isostretch/mesh/types.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace isostretch::mesh {

/// A set of elements to which a file gives a common number, and perhaps a name: a physical group of Gmsh, a
/// reference of MEDIT, a region of TetGen.
struct ElementGroup {
  std::int64_t number = 0;    ///< The number that the file gives.
  std::string name;           ///< The name; empty where the file has none.
  std::vector<int> elements;  ///< Indices of elements, ascending.
  /// Indices of vertices, ascending, of a group of faces, lines or points, which are no elements of the body.
  std::vector<int> vertices = {};
};

/// A mesh of elements of one shape as a file has it: solid elements, or flat ones in space where there are
/// none.
struct ElementMesh {
  Shape shape = Shape::tet;  ///< The shape of all elements.
  Points3 vertices;          ///< V x 3, in the order of the file.
  /// E x the nodes of the shape, indices into vertices, nodes in VTK's order.
  Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor | Eigen::DontAlign> elements;
  /// Groups of elements by number, then groups of faces, lines and points by dimension and number. An element
  /// may be in several groups, or in none.
  std::vector<ElementGroup> groups;
};

}  // namespace isostretch::mesh

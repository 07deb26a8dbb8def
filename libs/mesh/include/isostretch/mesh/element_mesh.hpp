#pragma once

#include <isostretch/mesh/shape.hpp>
#include <isostretch/mesh/types.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace isostretch::mesh {

/// Elements that a file gives a number, and perhaps a name, in common: a physical group of Gmsh, a reference
/// of MEDIT, a region of TetGen.
struct ElementGroup {
  std::int64_t number = 0;
  std::string name;           ///< empty where the file has none
  std::vector<int> elements;  ///< ascending, from 0
  /// Of a group of faces, lines or points, which are no elements of the body: their vertices, ascending.
  std::vector<int> vertices = {};
};

/// Elements of one kind as a file has them: solid ones, or without any flat ones in space.
struct ElementMesh {
  Shape shape = Shape::tet;
  Points3 vertices;  ///< #V x 3, in the order of the file
  /// #E x the nodes of the shape, into vertices, in VTK's order (see types.hpp).
  Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor | Eigen::DontAlign> elements;
  /// Those of elements by number, then those of faces, lines and points, by dimension and number. An element
  /// may be in several, or in none.
  std::vector<ElementGroup> groups;
};

}  // namespace isostretch::mesh

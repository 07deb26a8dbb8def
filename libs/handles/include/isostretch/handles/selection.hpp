#pragma once

#include <isostretch/core/vector.hpp>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace isostretch::handles {

/// A point; in 2D the last coordinate is ignored.
using Point = Eigen::Vector3d;

/// A set of nodes to which a file gives a common number, and perhaps a name.
struct NodeGroup {
  std::int64_t number = 0;  ///< The number that the file gives.
  std::string name;         ///< The name; empty where the file has none.
  std::vector<int> nodes;   ///< Indices of nodes.
};

/// The nodes of a body at rest, from which handles are selected.
struct Nodes {
  int dim = 3;       ///< Dimension, 2 or 3.
  Vector positions;  ///< Rest positions, dim entries per node.
  /// A flag per node that says whether it belongs to an element; empty where all do. Other nodes are not
  /// selected, and are ignored for extents and distances.
  std::vector<bool> in_elements;
  std::vector<NodeGroup> groups;  ///< Groups that can be selected.
  /// Edges between nodes on the boundary, which Patch alone uses.
  std::vector<std::array<int, 2>> boundary_edges;

  /// Returns whether a node belongs to an element.
  bool counts(int node) const { return in_elements.empty() || in_elements[static_cast<std::size_t>(node)]; }
  /// Returns the number of nodes.
  int count() const { return static_cast<int>(positions.size()) / dim; }
  /// Returns the rest position of a node.
  Point at(int node) const {
    Point point = Point::Zero();
    for (int i = 0; i < dim; ++i) point[i] = positions[dim * node + i];
    return point;
  }
};

/// A selection of all nodes.
struct All {};

/// A selection of the nodes in a box, its faces included.
struct Box {
  /// The corner with the smallest coordinates.
  Point low = Point::Zero(), high = Point::Zero();  ///< The corner with the largest coordinates.
};

/// A selection of the nodes in a ball, its surface included.
struct Sphere {
  Point center = Point::Zero();  ///< Centre.
  double radius = 0;             ///< Radius.
};

/// A selection of nodes by their indices.
struct List {
  std::vector<int> nodes;  ///< Indices of nodes, in any order.
};

/// The end of an axis: its lowest or its highest coordinate.
enum class End { min, max };

/// A selection of the nodes within `width` of the lowest or highest coordinate along an axis.
struct Slab {
  int axis = 0;          ///< Axis, from 0.
  End end = End::min;    ///< End of the body along the axis.
  double width = 0;      ///< Distance from that end.
  bool relative = true;  ///< Whether width is a fraction of the extent along the axis.
};

/// A selection of the nodes nearest to a point; of equally near ones those with the smaller numbers.
struct Nearest {
  Point point = Point::Zero();  ///< Point.
  int count = 1;                ///< Number of nodes.
};

/// A selection of the nodes of the boundary within a distance, along edges of the boundary, of its node
/// nearest to a point.
struct Patch {
  Point point = Point::Zero();  ///< Point.
  double distance = 0;          ///< Distance along edges.
};

/// A selection of the nodes within a distance of the straight line between two points, which may be one: a
/// bone.
struct Segment {
  /// One end of the line.
  Point from = Point::Zero(), to = Point::Zero();  ///< The other end of the line.
  double distance = 0;                             ///< Distance from the line.
};

/// A selection of the nodes of a group, by its name or, where no group has that name, by its number.
struct Group {
  std::string name;  ///< Name, or number in decimal digits.
};

/// A way to select nodes of a body.
using Selection = std::variant<All, Box, Sphere, List, Slab, Nearest, Patch, Segment, Group>;

/// Returns the index of a group by its name or number. Throws Error, beginning with `name`, which lists the
/// groups that exist, if there is none.
std::size_t find_group(const std::string& wanted, const std::vector<NodeGroup>& groups,
                       const std::string& name);

/// Returns the nodes selected, ascending, each once. Throws Error, beginning with `name`, when there are
/// none, for a node out of range, for a group that does not exist, and for sizes, axes and counts that make
/// no sense.
std::vector<int> select(const Selection& selection, const Nodes& nodes, const std::string& name);

}  // namespace isostretch::handles

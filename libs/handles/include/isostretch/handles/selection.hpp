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

/// In 2D the last coordinate is not looked at.
using Point = Eigen::Vector3d;

/// Nodes that a file gives a number, and perhaps a name, in common.
struct NodeGroup {
  std::int64_t number = 0;
  std::string name;  ///< empty where there is none
  std::vector<int> nodes;
};

/// What is selected from: the nodes of a body at rest.
struct Nodes {
  int dim = 3;
  Vector positions;  ///< dim entries a node
  /// Of every node whether it belongs to an element; empty: all do. Others are not selected, and are not
  /// looked at for extents and distances.
  std::vector<bool> in_elements;
  std::vector<NodeGroup> groups;
  std::vector<std::array<int, 2>> boundary_edges;  ///< between nodes on the boundary; patches alone use them

  bool counts(int node) const { return in_elements.empty() || in_elements[static_cast<std::size_t>(node)]; }
  int count() const { return static_cast<int>(positions.size()) / dim; }
  Point at(int node) const {
    Point point = Point::Zero();
    for (int i = 0; i < dim; ++i) point[i] = positions[dim * node + i];
    return point;
  }
};

struct All {};

struct Box {  // its faces included
  Point low = Point::Zero(), high = Point::Zero();
};

struct Sphere {  // its surface included
  Point center = Point::Zero();
  double radius = 0;
};

struct List {
  std::vector<int> nodes;
};

enum class End { min, max };

/// Nodes within `width` of the lowest or highest coordinate along an axis.
struct Slab {
  int axis = 0;
  End end = End::min;
  double width = 0;
  bool relative = true;  ///< width is a fraction of the extent along the axis
};

struct Nearest {  // of equally near ones those with the smaller numbers
  Point point = Point::Zero();
  int count = 1;
};

/// Nodes of the boundary within a distance, along edges of the boundary, of its node nearest to a point.
struct Patch {
  Point point = Point::Zero();
  double distance = 0;
};

/// A bone: nodes within a distance of the straight line between two points, which may be one.
struct Segment {
  Point from = Point::Zero(), to = Point::Zero();
  double distance = 0;
};

/// The nodes of a group, by its name or, where no group has that name, by its number.
struct Group {
  std::string name;
};

using Selection = std::variant<All, Box, Sphere, List, Slab, Nearest, Patch, Segment, Group>;

/// The index of a group by its name or number. Throws Error, beginning with `name`, that lists those there
/// are.
std::size_t find_group(const std::string& wanted, const std::vector<NodeGroup>& groups,
                       const std::string& name);

/// The nodes selected, ascending, each once. Throws Error, beginning with `name`, when there are none, for a
/// node out of range, for a group that there is not, and for sizes, axes and counts that make no sense.
std::vector<int> select(const Selection& selection, const Nodes& nodes, const std::string& name);

}  // namespace isostretch::handles

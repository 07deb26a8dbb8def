#pragma once

#include <vector>

namespace isostretch::mesh {

struct Welded {
  std::vector<double> points;  // x, y, z each, in the order of their first appearance
  std::vector<int> index;      // of every point given
};

// Makes one point of those that are equal, or with a tolerance no farther than that from one that was kept
// before; -0.0 equals 0.0. The first of several within reach is taken. Coordinates are finite.
Welded weld(const std::vector<double>& points, double tolerance);

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/surface/cut.hpp>

#include <vector>

namespace isostretch::mesh {

// Triangles and what passes between them: half-edge 3 * triangle + corner leads across that side.
struct TriangleGraph {
  std::vector<int> opposite;        // half-edge on the other side, -1 where there is none
  std::vector<long long> capacity;  // of every half-edge, the same for both of a side
  double unit = 1;                  // what a capacity of 1 stands for
};

// Sides that two triangles of one chart share, by their length in space; as whole numbers, whose sums have no
// order. A side that touches the boundary so near the end of the cut that a path from there would leave a
// spur counts so many times longer.
TriangleGraph triangle_graph(const Cut& cut, int spur_detour);

}  // namespace isostretch::mesh

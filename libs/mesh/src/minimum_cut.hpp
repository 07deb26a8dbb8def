#pragma once

#include <vector>

namespace isostretch::mesh {

// Triangles and what passes between them: half-edge 3 * triangle + corner leads across that side.
struct TriangleGraph {
  std::vector<int> opposite;        // half-edge on the other side, -1 where there is none
  std::vector<long long> capacity;  // of every half-edge, the same for both of a side
};

// Separates triangles marked 1 from those marked 2 by sides of the least total capacity, among triangles
// whose mark is not negative. Returns a flag for the triangles that remain with the first: of several least
// cuts the one nearest to them. (Maximum flow: Dinic 1970.)
std::vector<char> minimum_cut(const TriangleGraph& graph, const std::vector<signed char>& mark);

}  // namespace isostretch::mesh

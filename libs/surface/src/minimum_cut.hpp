#pragma once

#include "triangle_graph.hpp"

#include <limits>
#include <vector>

namespace isostretch::mesh {

// Separates triangles marked 1 from those marked 2 by sides of the least total capacity, among triangles
// whose mark is not negative. Returns a flag for the triangles that remain with the first: of several least
// cuts the one nearest to them. Empty where the least is `limit` or more, which is found out sooner. (Maximum
// flow: Dinic 1970.)
std::vector<char> minimum_cut(const TriangleGraph& graph, const std::vector<signed char>& mark,
                              long long limit = std::numeric_limits<long long>::max());

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// One side of a triangle: from corner `corner` of it to the next.
struct Side {
  int low, high;  ///< vertices of the edge, ordered
  int triangle;
  int corner;
  bool reversed;  ///< the triangle runs from high to low
  int from() const { return reversed ? high : low; }
  int to() const { return reversed ? low : high; }
};

/// All sides, sorted so that those of one edge are neighbours. Degenerate triangles (repeated vertex)
/// contribute none.
std::vector<Side> sorted_sides(const Triangles& triangles);

/// Calls visit(first, last) with the range of sides of every edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, const Visit& visit) {
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high)
      ++end;
    visit(sides.data() + begin, sides.data() + end);
    begin = end;
  }
}

class UnionFind {
 public:
  explicit UnionFind(int count);
  int find(int i);
  void unite(int i, int j);

 private:
  std::vector<int> parent_;
};

/// Corners (3 * triangle + local corner) of one vertex that triangles reach from each other through common
/// edges.
UnionFind corner_fans(const Triangles& triangles, const std::vector<Side>& sides);
/// Joins the corners at both ends of the edge of two sides.
void join_corners(UnionFind& fans, const Side& a, const Side& b);

}  // namespace isostretch::mesh

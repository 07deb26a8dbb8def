#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// A side of a triangle: from corner `corner` of it to the next.
struct Side {
  /// The smaller vertex of the edge.
  int low, high;  ///< The larger vertex of the edge.
  int triangle;   ///< Index of the triangle.
  int corner;     ///< Local corner where the side begins.
  bool reversed;  ///< Whether the triangle runs from high to low.
  /// Returns the vertex where the side begins.
  int from() const { return reversed ? high : low; }
  /// Returns the vertex where the side ends.
  int to() const { return reversed ? low : high; }
};

/// Returns all sides of all triangles, sorted so that those of one edge are neighbours. Degenerate triangles,
/// which repeat a vertex, contribute none.
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

/// A partition of 0 ... count - 1 into sets that can be united.
class UnionFind {
 public:
  /// Makes a set of each number.
  explicit UnionFind(int count);
  /// Returns the representative of the set that i is in.
  int find(int i);
  /// Unites the sets that i and j are in.
  void unite(int i, int j);

 private:
  std::vector<int> parent_;
};

/// Returns the fans of triangles as sets of corners (3 * triangle + local corner): those of one vertex that
/// triangles reach from each other through common edges.
UnionFind corner_fans(const Triangles& triangles, const std::vector<Side>& sides);
/// Joins the corners at both ends of the edge of two sides.
void join_corners(UnionFind& fans, const Side& a, const Side& b);

}  // namespace isostretch::mesh

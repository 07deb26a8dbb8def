#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace isostretch::mesh {
namespace {

bool repeats_vertex(const Triangles& triangles, Eigen::Index t) {
  return triangles(t, 0) == triangles(t, 1) || triangles(t, 1) == triangles(t, 2) ||
         triangles(t, 2) == triangles(t, 0);
}

int corner_at(const Side& side, int vertex) {
  return 3 * side.triangle + (vertex == side.from() ? side.corner : (side.corner + 1) % 3);
}

// Sorts sides whose triangles ascend. Vertices are the numbers of a mesh as a rule, which counting sorts in
// no time, and a vertex has few edges.
void sort_by_edge(std::vector<Side>& sides) {
  const auto comes_first = [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  };
  if (sides.empty()) return;
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end(),
                                                 [](const Side& a, const Side& b) { return a.low < b.low; });
  const long long first = least->low, range = most->low - first + 1;
  if (range > 4 * static_cast<long long>(sides.size()))
    return std::sort(sides.begin(), sides.end(), comes_first);

  std::vector<std::size_t> start(static_cast<std::size_t>(range) + 1, 0);
  for (const Side& side : sides) ++start[static_cast<std::size_t>(side.low - first) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Side> sorted(sides.size());
  std::vector<std::size_t> place(start.begin(), start.end() - 1);
  for (const Side& side : sides) sorted[place[static_cast<std::size_t>(side.low - first)]++] = side;
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(start[v]),
              sorted.begin() + static_cast<std::ptrdiff_t>(start[v + 1]), comes_first);
  sides.swap(sorted);
}

}  // namespace

std::vector<Side> sorted_sides(const Triangles& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    if (repeats_vertex(triangles, t)) continue;
    for (int corner = 0; corner < 3; ++corner) {
      const int from = triangles(t, corner), to = triangles(t, (corner + 1) % 3);
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), corner, from > to});
    }
  }
  sort_by_edge(sides);
  return sides;
}

UnionFind::UnionFind(int count) : parent_(static_cast<std::size_t>(count)) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

int UnionFind::find(int i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

// The smaller index becomes the root, so that results do not depend on the order of calls.
void UnionFind::unite(int i, int j) {
  i = find(i);
  j = find(j);
  parent_[std::max(i, j)] = std::min(i, j);
}

void join_corners(UnionFind& fans, const Side& a, const Side& b) {
  for (const int vertex : {a.low, a.high}) fans.unite(corner_at(a, vertex), corner_at(b, vertex));
}

UnionFind corner_fans(const Triangles& triangles, const std::vector<Side>& sides) {
  UnionFind fans(3 * static_cast<int>(triangles.rows()));
  for_each_edge(sides, [&](const Side* begin, const Side* end) {
    for (const Side* side = begin + 1; side < end; ++side) join_corners(fans, *begin, *side);
  });
  return fans;
}

}  // namespace isostretch::mesh

#pragma once

#include "half_edges.hpp"

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace isostretch::mesh {

struct ShortestPaths {
  std::vector<double> distance;  // infinite where the search did not come
  std::vector<int> via;          // a half-edge of the edge by which the vertex was reached; -1 at sources
  std::vector<int> order;        // vertices as they were reached
  int last = -1;                 // of them: the farthest, or the one that ended the search

  // The vertex before v, which must not be a source.
  int before(const HalfEdges& surface, int v) const {
    const int h = via[static_cast<std::size_t>(v)];
    return surface.from(h) == v ? surface.to(h) : surface.from(h);
  }
  // Half-edges from v back to its source.
  std::vector<int> path(const HalfEdges& surface, int v) const {
    std::vector<int> half_edges;
    for (; via[static_cast<std::size_t>(v)] >= 0; v = before(surface, v))
      half_edges.push_back(via[static_cast<std::size_t>(v)]);
    return half_edges;
  }
};

// Dijkstra over edges from any of the sources. Vertices are reached in the order of their distance until
// stop(vertex, distance) is true.
template <class Stop>
ShortestPaths shortest_paths(const HalfEdges& surface, const std::vector<double>& weights,
                             const std::vector<int>& sources, const Stop& stop) {
  const auto n = surface.outgoing.size();
  ShortestPaths paths{
      std::vector<double>(n, std::numeric_limits<double>::infinity()), std::vector<int>(n, -1), {}};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int source : sources) {
    paths.distance[static_cast<std::size_t>(source)] = 0;
    queue.emplace(0.0, source);
  }
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > paths.distance[static_cast<std::size_t>(vertex)]) continue;
    paths.order.push_back(vertex);
    paths.last = vertex;
    if (stop(vertex, distance)) break;
    for_each_neighbour(surface, vertex, [&, from = distance](int h, int neighbour) {
      const double through = from + weights[static_cast<std::size_t>(h)];
      double& known = paths.distance[static_cast<std::size_t>(neighbour)];
      if (!(through < known)) return;
      known = through;
      paths.via[static_cast<std::size_t>(neighbour)] = h;
      queue.emplace(through, neighbour);
    });
  }
  return paths;
}

inline ShortestPaths shortest_paths(const HalfEdges& surface, const std::vector<double>& weights,
                                    const std::vector<int>& sources) {
  return shortest_paths(surface, weights, sources, [](int, double) { return false; });
}

}  // namespace isostretch::mesh

#include "triangle_graph.hpp"

#include "spur.hpp"

#include <isostretch/core/index.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::mesh {
namespace {

// Vertices of the boundary so near the end of a cut that a path from there would leave a spur.
std::vector<char> leaving_spurs(const Cut& cut, const std::vector<Side>& sides) {
  std::vector<int> next(cut.original_vertex.size(), -1), previous(next);
  for_each_edge(sides, [&](const Side* begin, const Side* end) {
    if (end - begin != 1) return;
    next[at(begin->from())] = begin->to();
    previous[at(begin->to())] = begin->from();
  });
  const auto is_end = [&](int v) {
    return next[at(v)] >= 0 &&
           cut.original_vertex[at(next[at(v)])] == cut.original_vertex[at(previous[at(v)])];
  };
  std::vector<char> leaving(next.size(), 0);
  for (int v = 0; v < static_cast<int>(next.size()); ++v)
    for (const auto* direction : {&next, &previous}) {
      int there = v;
      for (int i = 1; i < least_branch && is_end(v) && !is_end(there = (*direction)[at(there)]); ++i)
        leaving[at(there)] = 1;
    }
  return leaving;
}

}  // namespace

TriangleGraph triangle_graph(const Cut& cut, int spur_detour) {
  constexpr double resolution = 1e9;
  const SurfaceMesh& mesh = cut.mesh;
  const std::vector<int>& group = cut.chart;
  const std::vector<Side> sides = sorted_sides(mesh.triangles);
  TriangleGraph graph;
  graph.opposite.assign(3 * group.size(), -1);
  graph.capacity.assign(3 * group.size(), 0);
  std::vector<double> lengths(3 * group.size(), 0);
  for_each_edge(sides, [&](const Side* begin, const Side* end) {
    if (end - begin != 2 || group[at(begin->triangle)] != group[at(begin[1].triangle)]) return;
    const int a = 3 * begin->triangle + begin->corner, b = 3 * begin[1].triangle + begin[1].corner;
    graph.opposite[at(a)] = b;
    graph.opposite[at(b)] = a;
    lengths[at(a)] = lengths[at(b)] = length(edge_vector(mesh.vertices, begin->low, begin->high));
  });
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  graph.unit = longest / resolution;
  for (std::size_t h = 0; h < lengths.size(); ++h)
    if (lengths[h] > 0) graph.capacity[h] = 1 + std::llround(lengths[h] / longest * resolution);
  if (spur_detour == 1) return graph;
  const std::vector<char> leaving = leaving_spurs(cut, sides);
  for (std::size_t h = 0; h < lengths.size(); ++h) {
    const auto t = static_cast<Eigen::Index>(h / 3), c = static_cast<Eigen::Index>(h % 3);
    if (leaving[at(mesh.triangles(t, c))] || leaving[at(mesh.triangles(t, (c + 1) % 3))])
      graph.capacity[h] *= spur_detour;
  }
  return graph;
}

}  // namespace isostretch::mesh

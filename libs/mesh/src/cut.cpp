#include "measure.hpp"
#include "topology.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/check.hpp>
#include <isostretch/mesh/cut.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace isostretch::mesh {
namespace {

void require_sphere(const SurfaceMesh& mesh) {
  const Report report = check(mesh, 1);
  const auto refuse = [](const std::string& why) { throw Error("cannot cut the mesh open: " + why); };
  for (const Finding& finding : report.findings)
    if (finding.kind != Kind::zero_size) refuse(finding.text);
  if (report.components == 0) refuse("it has no triangles");
  if (report.boundary_loops > 0)
    refuse("it is not closed, it has " + std::to_string(report.boundary_loops) + " boundary loop(s)");
  if (report.genus != 0)
    refuse("it has genus " + std::to_string(report.genus) + ", a single cut only opens genus 0");
}

// The edge graph of a mesh, neighbours of vertex v at [start[v], start[v + 1]).
struct Graph {
  std::vector<int> start, neighbour;
  std::vector<double> distance;
};

Graph edge_graph(const SurfaceMesh& mesh, const std::vector<Side>& sides, bool unit_lengths) {
  Graph graph;
  graph.start.assign(static_cast<std::size_t>(mesh.vertices.rows()) + 1, 0);
  for (const Side& side : sides) ++graph.start[static_cast<std::size_t>(side.from()) + 1];
  for (std::size_t v = 1; v < graph.start.size(); ++v) graph.start[v] += graph.start[v - 1];
  graph.neighbour.resize(sides.size());
  graph.distance.resize(sides.size());
  std::vector<int> next = graph.start;
  for (const Side& side : sides) {  // closed and oriented: every edge occurs once in each direction
    const auto slot = static_cast<std::size_t>(next[static_cast<std::size_t>(side.from())]++);
    graph.neighbour[slot] = side.to();
    graph.distance[slot] = unit_lengths ? 1.0 : length(edge_vector(mesh.vertices, side.low, side.high));
  }
  return graph;
}

struct ShortestPaths {
  std::vector<double> distance;
  std::vector<int> previous;
  int farthest = 0;
};

ShortestPaths dijkstra(const Graph& graph, int source) {
  const std::size_t n = graph.start.size() - 1;
  ShortestPaths paths{std::vector<double>(n, std::numeric_limits<double>::infinity()),
                      std::vector<int>(n, -1), source};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  paths.distance[static_cast<std::size_t>(source)] = 0;
  queue.emplace(0.0, source);
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    const auto v = static_cast<std::size_t>(vertex);
    if (distance > paths.distance[v]) continue;
    paths.farthest = vertex;  // vertices are settled in order of distance
    for (int k = graph.start[v]; k < graph.start[v + 1]; ++k) {
      const auto e = static_cast<std::size_t>(k);
      const auto w = static_cast<std::size_t>(graph.neighbour[e]);
      const double through = distance + graph.distance[e];
      if (!(through < paths.distance[w])) continue;
      paths.distance[w] = through;
      paths.previous[w] = vertex;
      queue.emplace(through, graph.neighbour[e]);
    }
  }
  return paths;
}

std::vector<int> longest_shortest_path(const Graph& graph) {
  const ShortestPaths paths = dijkstra(graph, dijkstra(graph, 0).farthest);
  std::vector<int> path;
  for (int v = paths.farthest; v >= 0; v = paths.previous[static_cast<std::size_t>(v)]) path.push_back(v);
  return path;
}

// By length, or by number of edges where a few long edges span the whole surface.
std::vector<int> cutting_path(const SurfaceMesh& mesh, const std::vector<Side>& sides) {
  constexpr std::size_t least_vertices = 4;
  for (const bool unit_lengths : {false, true}) {
    std::vector<int> path = longest_shortest_path(edge_graph(mesh, sides, unit_lengths));
    if (path.size() >= least_vertices) return path;
  }
  throw Error("cannot cut the mesh open: it is too coarse, no two vertices are three edges apart");
}

// Corners that still reach each other around their vertex without crossing the path.
UnionFind fans_beside(const Triangles& triangles, const std::vector<Side>& sides,
                      const std::vector<int>& path) {
  std::vector<std::pair<int, int>> cut;
  for (std::size_t i = 1; i < path.size(); ++i) cut.emplace_back(std::minmax(path[i - 1], path[i]));
  std::sort(cut.begin(), cut.end());
  UnionFind fans(3 * static_cast<int>(triangles.rows()));
  for_each_edge(sides, [&](const Side* begin, const Side*) {
    if (!std::binary_search(cut.begin(), cut.end(), std::pair(begin->low, begin->high)))
      join_corners(fans, begin[0], begin[1]);
  });
  return fans;
}

}  // namespace

CutResult cut_to_disk_simple(const SurfaceMesh& mesh) {
  require_sphere(mesh);
  const std::vector<Side> sides = sorted_sides(mesh.triangles);
  CutResult result;
  result.path = cutting_path(mesh, sides);
  result.mesh = mesh;
  UnionFind fans = fans_beside(mesh.triangles, sides, result.path);

  const auto V = static_cast<int>(mesh.vertices.rows());
  const auto copies = static_cast<int>(result.path.size()) - 2;
  std::vector<int> copy_of(static_cast<std::size_t>(V), -1), kept_fan(static_cast<std::size_t>(V), -1);
  for (int i = 0; i < copies; ++i)
    copy_of[static_cast<std::size_t>(result.path[static_cast<std::size_t>(i) + 1])] = V + i;
  for (int corner = 0; corner < 3 * static_cast<int>(mesh.triangles.rows()); ++corner) {
    int& vertex = result.mesh.triangles(corner / 3, corner % 3);
    const auto v = static_cast<std::size_t>(vertex);
    if (copy_of[v] < 0) continue;
    const int fan = fans.find(corner);
    if (kept_fan[v] < 0) kept_fan[v] = fan;
    if (fan != kept_fan[v]) vertex = copy_of[v];
  }
  result.mesh.vertices.conservativeResize(V + copies, 3);
  for (int v = 0; v < V; ++v) result.original_vertex.push_back(v);
  for (int i = 0; i < copies; ++i) {
    const int original = result.path[static_cast<std::size_t>(i) + 1];
    result.mesh.vertices.row(V + i) = mesh.vertices.row(original);
    result.original_vertex.push_back(original);
  }
  return result;
}

}  // namespace isostretch::mesh

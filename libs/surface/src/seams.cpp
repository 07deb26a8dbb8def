
#include <isostretch/mesh/measure.hpp>
#include <isostretch/mesh/require.hpp>
#include <isostretch/surface/seams.hpp>
#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::mesh {
namespace {

int uv_at(const SurfaceMesh& mesh, const Side& side, int vertex) {
  const int corner = vertex == side.from() ? side.corner : (side.corner + 1) % 3;
  return mesh.uv_triangles(side.triangle, corner);
}

bool same_uv(const SurfaceMesh& mesh, const Side& a, const Side& b, int vertex) {
  const int p = uv_at(mesh, a, vertex), q = uv_at(mesh, b, vertex);
  return p == q || mesh.uv.row(p) == mesh.uv.row(q);
}

// Edges at every vertex as indices into the list, those of vertex v at [start[v], start[v + 1]).
struct Incidence {
  std::vector<int> start, edge;
  int degree(int v) const {
    return start[static_cast<std::size_t>(v) + 1] - start[static_cast<std::size_t>(v)];
  }
};

Incidence incidence(const std::vector<Edge>& edges) {
  Incidence result;
  int largest = -1;
  for (const Edge& edge : edges) largest = std::max(largest, edge.high);
  result.start.assign(static_cast<std::size_t>(largest) + 2, 0);
  for (const Edge& edge : edges)
    for (const int v : {edge.low, edge.high}) ++result.start[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < result.start.size(); ++v) result.start[v] += result.start[v - 1];
  result.edge.resize(2 * edges.size());
  std::vector<int> next = result.start;
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const int v : {edges[e].low, edges[e].high})
      result.edge[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = static_cast<int>(e);
  return result;
}

class PathWalk {
 public:
  explicit PathWalk(const std::vector<Edge>& edges)
      : edges_(edges), at_(incidence(edges)), used_(edges.size(), 0) {}

  void walk_from(int start, std::vector<std::vector<int>>& paths) {
    for (int e = unused_edge(start); e >= 0; e = unused_edge(start)) {
      std::vector<int>& path = paths.emplace_back(1, start);
      for (int vertex = start; e >= 0; e = passes(vertex, start) ? unused_edge(vertex) : -1) {
        used_[static_cast<std::size_t>(e)] = 1;
        const Edge& edge = edges_[static_cast<std::size_t>(e)];
        vertex = edge.low == vertex ? edge.high : edge.low;
        path.push_back(vertex);
      }
    }
  }
  bool is_end(int v) const { return at_.degree(v) != 2; }

 private:
  bool passes(int vertex, int start) const { return vertex != start && !is_end(vertex); }
  int unused_edge(int v) const {
    for (int k = at_.start[static_cast<std::size_t>(v)]; k < at_.start[static_cast<std::size_t>(v) + 1];
         ++k) {
      const int e = at_.edge[static_cast<std::size_t>(k)];
      if (!used_[static_cast<std::size_t>(e)]) return e;
    }
    return -1;
  }

  const std::vector<Edge>& edges_;
  Incidence at_;
  std::vector<char> used_;
};

}  // namespace

std::vector<Edge> seams_of_uv(const SurfaceMesh& mesh) {
  if (!mesh.has_uv()) throw Error("the mesh has no texture coordinates to take seams from");
  if (mesh.uv_triangles.rows() != mesh.triangles.rows())
    throw Error("the mesh has " + std::to_string(mesh.triangles.rows()) + " triangles, but " +
                std::to_string(mesh.uv_triangles.rows()) + " triangles of texture coordinates");
  require_indices(mesh.triangles, mesh.vertices.rows(), "triangle");
  require_indices(mesh.uv_triangles, mesh.uv.rows(), "texture triangle");
  std::vector<Edge> seams;
  for_each_edge(sorted_sides(mesh.triangles), [&](const Side* begin, const Side* end) {
    for (const Side* side = begin + 1; side < end; ++side)
      if (!same_uv(mesh, *begin, *side, begin->low) || !same_uv(mesh, *begin, *side, begin->high)) {
        seams.push_back({begin->low, begin->high});
        return;
      }
  });
  return seams;
}

std::vector<std::vector<int>> seam_paths(std::vector<Edge> edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  PathWalk walk(edges);
  std::vector<std::vector<int>> paths;
  for (const bool closed : {false, true})  // what is left after all paths with ends
    for (const Edge& edge : edges)
      for (const int v : {edge.low, edge.high})
        if (closed || walk.is_end(v)) walk.walk_from(v, paths);
  return paths;
}

double seam_length(const Points3& vertices, const std::vector<Edge>& edges) {
  double sum = 0;
  for (const Edge& edge : edges) sum += length(edge_vector(vertices, edge.low, edge.high));
  return sum;
}

}  // namespace isostretch::mesh

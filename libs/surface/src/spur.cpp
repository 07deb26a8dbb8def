#include "spur.hpp"

#include <isostretch/core/index.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <map>

namespace isostretch::mesh {
namespace {

// The seams as a graph of vertices of the input; what lies on the boundary of the input too is marked.
struct SeamGraph {
  std::map<int, std::vector<int>> neighbours;
  std::vector<char> on_boundary;  // of vertices of the input

  explicit SeamGraph(const Cut& cut) {
    for (const Edge& edge : cut.seams) {
      neighbours[edge.low].push_back(edge.high);
      neighbours[edge.high].push_back(edge.low);
    }
    const auto most = std::max_element(cut.original_vertex.begin(), cut.original_vertex.end());
    if (most != cut.original_vertex.end()) on_boundary.assign(at(*most) + 1, 0);
    for_each_edge(sorted_sides(cut.mesh.triangles), [&](const Side* begin, const Side* end) {
      if (end - begin != 1) return;
      const auto [low, high] =
          std::minmax(cut.original_vertex[at(begin->low)], cut.original_vertex[at(begin->high)]);
      if (std::binary_search(cut.seams.begin(), cut.seams.end(), Edge{low, high})) return;
      on_boundary[at(low)] = on_boundary[at(high)] = 1;
    });
  }

  bool is_end(int v) const { return neighbours.at(v).size() == 1 && !on_boundary[at(v)]; }
  bool is_inner(int v) const { return neighbours.at(v).size() == 2 && !on_boundary[at(v)]; }
};

}  // namespace

std::vector<std::vector<int>> spurs(const Cut& cut) {
  const SeamGraph graph(cut);
  std::vector<std::vector<int>> found;
  for (const auto& [v, neighbours] : graph.neighbours) {
    if (!graph.is_end(v)) continue;
    std::vector<int> path{v, neighbours.front()};
    while (static_cast<int>(path.size()) <= least_branch && graph.is_inner(path.back())) {
      const std::vector<int>& next = graph.neighbours.at(path.back());
      path.push_back(next[0] == path[path.size() - 2] ? next[1] : next[0]);
    }
    // What is no longer than that and ends at both sides is the whole cut of a piece.
    if (static_cast<int>(path.size()) <= least_branch && !graph.is_end(path.back()))
      found.push_back(std::move(path));
  }
  return found;
}

}  // namespace isostretch::mesh

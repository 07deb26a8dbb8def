#include "cut_graph.hpp"
#include "shortest_paths.hpp"

#include <isostretch/core/index.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::mesh {
namespace {

constexpr int max_sweeps = 3;
// What replaces a path must be shorter by more than this fraction: less may be rounding.
constexpr double least_gain = 1e-6;

struct Path {
  double weight = 0;
  std::vector<int> half_edges;
};

class Shortener {
 public:
  Shortener(const CutProblem& problem, EdgeMarks& graph) : problem_(problem), graph_(graph) {}

  // Longest first: an order that numbering has no part in. An earlier path may have divided a later one.
  bool sweep() {
    std::vector<int> all;
    for (int h = 0; h < surface().count(); ++h)
      if (surface().stands_for_edge(h)) all.push_back(h);
    bool shorter = false;
    for (const Path& path : paths_through(all)) {
      const std::vector<Path> now = paths_through(path.half_edges);
      if (!now.empty() && replace(now.front())) shorter = true;
    }
    return shorter;
  }

 private:
  const HalfEdges& surface() const { return problem_.surface; }
  bool inside(int h) const { return graph_[at(h)] && !surface().on_boundary(h); }

  // The one other marked edge at the vertex, or -1 at the end of a path.
  int continuation(int vertex, int edge) const {
    int degree = 0, other = -1;
    for_each_neighbour(surface(), vertex, [&](int h, int) {
      if (!graph_[at(h)]) return;
      ++degree;
      if (h != edge && surface().opposite[at(h)] != edge) other = h;
    });
    return degree == 2 ? other : -1;
  }

  // Returns whether it came back to where it began, which only a path without ends does.
  bool follow(int vertex, int edge, Path& path) const {
    const int start = edge;
    while ((edge = continuation(vertex, edge)) >= 0) {
      if (edge == start || surface().opposite[at(edge)] == start) return true;
      path.half_edges.push_back(edge);
      vertex = surface().from(edge) == vertex ? surface().to(edge) : surface().from(edge);
    }
    return false;
  }

  // All marked edges around h up to where paths meet.
  Path path_through(int h) const {
    Path path;
    path.half_edges.push_back(h);
    if (!follow(surface().to(h), h, path)) follow(surface().from(h), h, path);
    for (const int edge : path.half_edges) path.weight += problem_.weights[at(edge)];
    return path;
  }

  // Every path of the graph with one of the edges, the longest first.
  std::vector<Path> paths_through(const std::vector<int>& half_edges) const {
    std::vector<Path> paths;
    EdgeMarks seen(graph_.size(), 0);
    for (const int h : half_edges) {
      if (!inside(h) || seen[at(h)]) continue;
      paths.push_back(path_through(h));
      for (const int edge : paths.back().half_edges) mark(surface(), seen, edge);
    }
    std::sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) { return a.weight > b.weight; });
    return paths;
  }

  // 1 and 2 for the vertices of the two boundary loops, not counting holes that are kept; 0 for others.
  std::vector<char> sides(const Opened& opened) const {
    std::vector<char> side(opened.surface.outgoing.size(), 0);
    char next = 1;
    for (const std::vector<int>& loop : boundary_half_edges(opened.surface)) {
      const int known = problem_.loop_of_half_edge[at(loop.front())];
      if (known >= 0 && problem_.kept[at(known)]) continue;
      for (const int h : loop) side[at(opened.surface.from(h))] = next;
      ++next;
    }
    return side;
  }

  // The surface open along the graph without the path is an annulus. The shortest path between its two loops
  // opens it again.
  std::vector<int> crossing(double longest) const {
    EdgeMarks inner = graph_;
    for (int h = 0; h < surface().count(); ++h)
      if (surface().on_boundary(h)) inner[at(h)] = 0;
    const Opened opened = open_along(surface(), inner);
    const std::vector<char> side = sides(opened);
    std::vector<int> sources;
    for (std::size_t v = 0; v < side.size(); ++v)
      if (side[v] == 1) sources.push_back(static_cast<int>(v));
    const ShortestPaths paths =
        shortest_paths(opened.surface, problem_.weights, sources,
                       [&](int v, double distance) { return side[at(v)] == 2 || distance >= longest; });
    if (paths.last < 0 || side[at(paths.last)] != 2 || paths.distance[at(paths.last)] >= longest) return {};
    return paths.path(opened.surface, paths.last);
  }

  bool touches_kept_hole(const std::vector<int>& path) const {
    return std::any_of(path.begin(), path.end(), [&](int h) {
      return problem_.on_kept_loop[at(surface().from(h))] || problem_.on_kept_loop[at(surface().to(h))];
    });
  }

  double graph_weight() const { return marked_weight(surface(), graph_, problem_.weights); }

  bool replace(const Path& old) {
    const EdgeMarks before = graph_;
    const double weight = graph_weight();
    std::vector<int> ends;
    for (const int h : old.half_edges) {
      mark(surface(), graph_, h, false);
      ends.push_back(surface().from(h));
      ends.push_back(surface().to(h));
    }
    prune(surface(), graph_, ends);
    const std::vector<int> path = crossing((weight - graph_weight()) * (1 - least_gain));
    if (path.empty() || touches_kept_hole(path)) {
      graph_ = before;
      return false;
    }
    for (const int h : path) mark(surface(), graph_, h);
    return true;
  }

  const CutProblem& problem_;
  EdgeMarks& graph_;
};

}  // namespace

void shorten_cut(const CutProblem& problem, EdgeMarks& graph) {
  Shortener shortener(problem, graph);
  for (int i = 0; i < max_sweeps; ++i)
    if (!shortener.sweep()) return;
}

}  // namespace isostretch::mesh

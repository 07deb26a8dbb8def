#include "cut_graph.hpp"

#include "shortest_paths.hpp"

#include <isostretch/core/index.hpp>
#include <isostretch/surface/topology.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace isostretch::mesh {
namespace {

constexpr int base_points = 6;          // tried for surfaces with handles
constexpr double keep_away_factor = 8;  // of edges at holes that are kept

CutProblem make_problem(const Piece& piece, const std::vector<char>& kept) {
  const HalfEdges& surface = piece.surface;
  CutProblem problem{surface, piece.weights, std::vector<int>(at(surface.count()), -1), kept,
                     std::vector<char>(surface.outgoing.size(), 0)};
  for (std::size_t loop = 0; loop < piece.loops.size(); ++loop)
    for (const int h : piece.loops[loop]) {
      problem.loop_of_half_edge[at(h)] = static_cast<int>(loop);
      if (kept[loop])
        problem.on_kept_loop[at(surface.from(h))] = 1;
      else
        problem.weights[at(h)] = 0;
    }
  for (int h = 0; h < surface.count(); ++h)
    if (problem.on_kept_loop[at(surface.from(h))] || problem.on_kept_loop[at(surface.to(h))])
      problem.weights[at(h)] *= keep_away_factor;
  return problem;
}

bool on_open_loop(const CutProblem& problem, int h) {
  const int loop = problem.loop_of_half_edge[at(h)];
  return loop >= 0 && !problem.kept[at(loop)];
}

// A loop that is cut to connects its own vertices: the tree needs to come to it once, where it came first.
void enter_loops_once(const CutProblem& problem, ShortestPaths& tree) {
  std::vector<char> entered(problem.kept.size(), 0);
  for (const int v : tree.order) {
    const int out = problem.surface.outgoing[at(v)];
    if (!on_open_loop(problem, out)) continue;
    char& known = entered[at(problem.loop_of_half_edge[at(out)])];
    if (known) tree.via[at(v)] = -1;
    known = 1;
  }
}

// Edges outside the tree, in the order in which the dual tree crosses them: longest loop through the root
// first. Edges of loops that are not kept have no face beyond them to cross to.
std::vector<int> dual_edges(const CutProblem& problem, const ShortestPaths& tree,
                            const std::vector<char>& in_tree) {
  const HalfEdges& surface = problem.surface;
  std::vector<std::pair<double, int>> order;
  for (int h = 0; h < surface.count(); ++h)
    if (surface.stands_for_edge(h) && !in_tree[at(h)] && !on_open_loop(problem, h))
      order.emplace_back(
          tree.distance[at(surface.from(h))] + tree.distance[at(surface.to(h))] + problem.weights[at(h)], h);
  std::sort(order.begin(), order.end(), std::greater<>());
  std::vector<int> edges;
  edges.reserve(order.size());
  for (const auto& [length, h] : order) edges.push_back(h);
  return edges;
}

// Edges neither in the tree nor crossed by the dual tree: two for every handle.
std::vector<int> left_over(const CutProblem& problem, const ShortestPaths& tree) {
  const HalfEdges& surface = problem.surface;
  std::vector<char> in_tree(at(surface.count()), 0);
  for (const int h : tree.via)
    if (h >= 0) mark(surface, in_tree, h);
  const auto faces = static_cast<int>(surface.triangles.rows());
  UnionFind joined(faces + static_cast<int>(problem.kept.size()));  // triangles, and kept holes as faces
  std::vector<int> edges;
  for (const int h : dual_edges(problem, tree, in_tree)) {
    const int beyond =
        surface.on_boundary(h) ? faces + problem.loop_of_half_edge[at(h)] : surface.opposite[at(h)] / 3;
    if (joined.find(h / 3) == joined.find(beyond))
      edges.push_back(h);
    else
      joined.unite(h / 3, beyond);
  }
  return edges;
}

// What the tree needs to reach the edges left over and the loops, without dead ends.
EdgeMarks graph_from_tree(const CutProblem& problem, const ShortestPaths& tree) {
  const HalfEdges& surface = problem.surface;
  EdgeMarks graph(at(surface.count()), 0);
  std::vector<char> reached(surface.outgoing.size(), 0);
  std::vector<int> vertices;
  const auto reach = [&](int v) {
    for (; v >= 0 && !reached[at(v)]; v = tree.via[at(v)] < 0 ? -1 : tree.before(surface, v)) {
      reached[at(v)] = 1;
      vertices.push_back(v);
      if (tree.via[at(v)] >= 0) mark(surface, graph, tree.via[at(v)]);
    }
  };
  for (const int h : left_over(problem, tree)) {
    mark(surface, graph, h);
    reach(surface.from(h));
    reach(surface.to(h));
  }
  for (int h = 0; h < surface.count(); ++h)
    if (on_open_loop(problem, h)) {
      mark(surface, graph, h);
      reach(surface.from(h));
    }
  prune(surface, graph, vertices);
  return graph;
}

// Base points: on the longest loop to be cut to, if there is one, and then each the farthest from all before.
EdgeMarks best_graph(const Piece& piece, const CutProblem& problem) {
  int root = piece.extreme;
  double longest = -1;
  for (std::size_t loop = 0; loop < piece.loops.size(); ++loop)
    if (!problem.kept[loop] && piece.loop_lengths[loop] > longest) {
      longest = piece.loop_lengths[loop];
      root = problem.surface.from(piece.loops[loop].front());
    }
  EdgeMarks best;
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> nearest(problem.surface.outgoing.size(), least);
  for (int trial = 0; trial < (piece.genus > 0 ? base_points : 1); ++trial) {
    ShortestPaths tree = shortest_paths(problem.surface, problem.weights, {root});
    enter_loops_once(problem, tree);
    EdgeMarks graph = graph_from_tree(problem, tree);
    const double weight = marked_weight(problem.surface, graph, problem.weights);
    if (weight < least) {
      least = weight;
      best = std::move(graph);
    }
    for (std::size_t v = 0; v < nearest.size(); ++v) nearest[v] = std::min(nearest[v], tree.distance[v]);
    root = static_cast<int>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
  }
  return best;
}

// Kept loops that the graph touches are kept no longer. Returns whether there are any.
bool give_up_touched(const CutProblem& problem, const Piece& piece, const EdgeMarks& graph,
                     std::vector<char>& kept) {
  std::vector<char> touched(problem.surface.outgoing.size(), 0);
  for (int h = 0; h < problem.surface.count(); ++h)
    if (graph[at(h)] && !on_open_loop(problem, h))
      touched[at(problem.surface.from(h))] = touched[at(problem.surface.to(h))] = 1;
  bool any = false;
  for (std::size_t loop = 0; loop < kept.size(); ++loop)
    if (kept[loop] && std::any_of(piece.loops[loop].begin(), piece.loops[loop].end(),
                                  [&](int h) { return touched[at(problem.surface.from(h))] != 0; })) {
      kept[loop] = 0;
      any = true;
    }
  return any;
}

}  // namespace

double marked_weight(const HalfEdges& surface, const EdgeMarks& marks, const std::vector<double>& weights) {
  double sum = 0;
  for (int h = 0; h < surface.count(); ++h)
    if (marks[at(h)] && surface.stands_for_edge(h)) sum += weights[at(h)];
  return sum;
}

void prune(const HalfEdges& surface, EdgeMarks& marks, std::vector<int> vertices) {
  while (!vertices.empty()) {
    const int vertex = vertices.back();
    vertices.pop_back();
    int degree = 0, only = -1, beyond = -1;
    for_each_neighbour(surface, vertex, [&](int h, int neighbour) {
      if (!marks[at(h)]) return;
      ++degree;
      only = h;
      beyond = neighbour;
    });
    if (degree != 1) continue;
    mark(surface, marks, only, false);
    vertices.push_back(beyond);
  }
}

EdgeMarks cut_graph(const Piece& piece, std::vector<char>& kept) {
  for (;;) {
    const CutProblem problem = make_problem(piece, kept);
    EdgeMarks graph = best_graph(piece, problem);
    if (give_up_touched(problem, piece, graph, kept)) continue;
    shorten_cut(problem, graph);
    for (int h = 0; h < piece.surface.count(); ++h)
      if (piece.surface.on_boundary(h)) graph[at(h)] = 0;
    return graph;
  }
}

}  // namespace isostretch::mesh

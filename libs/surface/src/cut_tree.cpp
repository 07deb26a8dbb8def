#include "cut_graph.hpp"
#include "shortest_paths.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::mesh {
namespace {

class Tree {
 public:
  explicit Tree(const Piece& piece)
      : piece_(piece), marks_(piece.surface.opposite.size(), 0), inside_(piece.surface.outgoing.size(), 0) {}

  const EdgeMarks& marks() const { return marks_; }
  const std::vector<int>& vertices() const { return vertices_; }
  double weight() const { return weight_; }
  bool contains(int v) const { return inside_[static_cast<std::size_t>(v)] != 0; }

  void add_vertex(int v) {
    if (!contains(v)) vertices_.push_back(v);
    inside_[static_cast<std::size_t>(v)] = 1;
  }
  void add_edge(int h) {
    mark(piece_.surface, marks_, h);
    weight_ += piece_.weights[static_cast<std::size_t>(h)];
    add_vertex(piece_.surface.from(h));
    add_vertex(piece_.surface.to(h));
  }
  ShortestPaths distances() const { return shortest_paths(piece_.surface, piece_.weights, vertices_); }

 private:
  const Piece& piece_;
  EdgeMarks marks_;
  std::vector<char> inside_;
  std::vector<int> vertices_;
  double weight_ = 0;
};

// A cut of one edge opens nothing: the shortest further edge is added to it.
void require_two_edges(const Piece& piece, Tree& tree) {
  if (tree.vertices().size() != 2) return;
  int shortest = -1;
  for (const int vertex : tree.vertices())
    for_each_neighbour(piece.surface, vertex, [&](int h, int neighbour) {
      const auto weight = [&](int edge) { return piece.weights[static_cast<std::size_t>(edge)]; };
      if (!tree.contains(neighbour) && (shortest < 0 || weight(h) < weight(shortest))) shortest = h;
    });
  tree.add_edge(shortest);
}

// The farthest vertex from the tree is joined to it, again and again. The first path is between the farthest
// vertex from an extreme one and the farthest from that.
Tree farthest_first(const Piece& piece, int max_terminals, double least_distance,
                    std::vector<int>& terminals) {
  Tree tree(piece);
  terminals = {shortest_paths(piece.surface, piece.weights, {piece.extreme}).last};
  tree.add_vertex(terminals.front());
  while (static_cast<int>(terminals.size()) < std::max(2, max_terminals)) {
    const ShortestPaths paths = tree.distances();
    if (terminals.size() > 1 && !(paths.distance[static_cast<std::size_t>(paths.last)] > least_distance))
      break;
    if (tree.contains(paths.last)) break;
    terminals.push_back(paths.last);
    for (const int h : paths.path(piece.surface, paths.last)) tree.add_edge(h);
  }
  return tree;
}

// The same ends joined to the tree in the order of their distance from it, which often takes less.
Tree nearest_first(const Piece& piece, const std::vector<int>& terminals) {
  Tree tree(piece);
  tree.add_vertex(terminals.front());
  std::vector<char> wanted(piece.surface.outgoing.size(), 0);
  for (const int v : terminals) wanted[static_cast<std::size_t>(v)] = 1;
  const auto missing = [&](int v) { return wanted[static_cast<std::size_t>(v)] && !tree.contains(v); };
  while (std::any_of(terminals.begin(), terminals.end(), missing)) {
    const ShortestPaths paths = shortest_paths(piece.surface, piece.weights, tree.vertices(),
                                               [&](int v, double) { return missing(v); });
    for (const int h : paths.path(piece.surface, paths.last)) tree.add_edge(h);
  }
  return tree;
}

}  // namespace

EdgeMarks cut_tree(const Piece& piece, int max_terminals, double terminal_distance) {
  std::vector<int> terminals;
  Tree tree = farthest_first(piece, max_terminals, terminal_distance * std::sqrt(piece.area), terminals);
  if (terminals.size() > 2) {
    const Tree other = nearest_first(piece, terminals);
    if (other.weight() < tree.weight()) return other.marks();
  }
  require_two_edges(piece, tree);
  return tree.marks();
}

}  // namespace isostretch::mesh

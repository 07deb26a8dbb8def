#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

// Connectivity of an oriented manifold. Half-edge 3 * triangle + corner runs from that corner to the next.
struct HalfEdges {
  Triangles triangles;
  std::vector<int> opposite;  // the half-edge of the other triangle at the edge, or -1 on the boundary
  std::vector<int> outgoing;  // a half-edge out of every vertex, the one on the boundary if there is one; -1

  int count() const { return static_cast<int>(opposite.size()); }
  int vertex_count() const { return static_cast<int>(outgoing.size()); }
  int from(int h) const { return triangles.data()[h]; }
  int to(int h) const { return triangles.data()[next(h)]; }
  // Around the triangle.
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  bool on_boundary(int h) const { return opposite[static_cast<std::size_t>(h)] < 0; }
  // One of the two half-edges of every edge, and that of a boundary edge.
  bool stands_for_edge(int h) const { return opposite[static_cast<std::size_t>(h)] < h; }
  bool boundary_vertex(int v) const {
    const int h = outgoing[static_cast<std::size_t>(v)];
    return h >= 0 && on_boundary(h);
  }
};

// The mesh must be manifold, consistently oriented and without degenerate triangles.
HalfEdges half_edges(const Triangles& triangles, int vertex_count);

// Calls visit(h, neighbour) for every edge at a vertex, counter-clockwise: h leaves the vertex, except for
// the last edge on the boundary, which only has a half-edge towards it.
template <class Visit>
void for_each_neighbour(const HalfEdges& surface, int vertex, const Visit& visit) {
  const int first = surface.outgoing[static_cast<std::size_t>(vertex)];
  for (int h = first; h >= 0;) {
    visit(h, surface.to(h));
    const int last = HalfEdges::previous(h);
    h = surface.opposite[static_cast<std::size_t>(last)];
    if (h < 0) visit(last, surface.from(last));
    if (h == first) return;
  }
}

// Half-edges of every boundary loop, one after the other.
std::vector<std::vector<int>> boundary_half_edges(const HalfEdges& surface);

// One flag for each half-edge, the same for both of an edge: edges to open.
using EdgeMarks = std::vector<char>;
void mark(const HalfEdges& surface, EdgeMarks& marks, int h, bool value = true);

struct Opened {
  HalfEdges surface;                 // half-edges keep their numbers
  std::vector<int> previous_vertex;  // vertices keep their numbers, copies come last
};

// Opens the marked edges: a vertex with several fans of triangles between marked and boundary edges becomes
// as many vertices, of which the fan of the smallest corner keeps the number.
Opened open_along(const HalfEdges& surface, const EdgeMarks& marks);

// Marked edges that share no vertex with another marked or boundary edge open nothing: unmarks them.
void unmark_lone_edges(const HalfEdges& surface, EdgeMarks& marks);

}  // namespace isostretch::mesh

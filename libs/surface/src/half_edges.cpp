#include "half_edges.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace isostretch::mesh {
namespace {

// Half-edges out of one vertex in a list: a vertex has few, so looking through them beats sorting.
std::vector<int> opposite_half_edges(const HalfEdges& surface) {
  const int count = 3 * static_cast<int>(surface.triangles.rows());
  std::vector<int> first(surface.outgoing.size(), -1), following(static_cast<std::size_t>(count));
  for (int h = 0; h < count; ++h)
    following[static_cast<std::size_t>(h)] =
        std::exchange(first[static_cast<std::size_t>(surface.from(h))], h);
  std::vector<int> opposite(static_cast<std::size_t>(count), -1);
  for (int h = 0; h < count; ++h)
    for (int other = first[static_cast<std::size_t>(surface.to(h))]; other >= 0;
         other = following[static_cast<std::size_t>(other)])
      if (surface.to(other) == surface.from(h)) opposite[static_cast<std::size_t>(h)] = other;
  return opposite;
}

// Where a walk around the vertex begins: at an open edge if there is one.
int first_opened(const HalfEdges& surface, const EdgeMarks& marks, int vertex) {
  const int first = surface.outgoing[static_cast<std::size_t>(vertex)];
  int found = -1;
  if (surface.on_boundary(first)) return first;
  for_each_neighbour(surface, vertex, [&](int h, int) {
    if (found < 0 && marks[static_cast<std::size_t>(h)]) found = h;
  });
  return found;
}

// Corners around a vertex in one fan for each space between open edges.
std::vector<std::vector<int>> fans_between(const HalfEdges& surface, const EdgeMarks& marks, int vertex) {
  std::vector<std::vector<int>> fans(1);
  const int first = first_opened(surface, marks, vertex);
  for (int h = first;;) {
    fans.back().push_back(h);
    const int last = HalfEdges::previous(h);
    h = surface.opposite[static_cast<std::size_t>(last)];
    if (h < 0 || h == first) return fans;
    if (marks[static_cast<std::size_t>(h)]) fans.emplace_back();
  }
}

void open_vertex(const HalfEdges& surface, const EdgeMarks& marks, int vertex, Opened& opened) {
  auto fans = fans_between(surface, marks, vertex);
  const auto smallest = [](const std::vector<int>& fan) { return *std::min_element(fan.begin(), fan.end()); };
  std::sort(fans.begin(), fans.end(),
            [&](const auto& a, const auto& b) { return smallest(a) < smallest(b); });
  for (std::size_t i = 0; i < fans.size(); ++i) {
    int number = vertex;
    if (i > 0) {
      number = static_cast<int>(opened.previous_vertex.size());
      opened.previous_vertex.push_back(vertex);
      opened.surface.outgoing.push_back(-1);
    }
    opened.surface.outgoing[static_cast<std::size_t>(number)] = fans[i].front();
    for (const int corner : fans[i]) opened.surface.triangles.data()[corner] = number;
  }
}

}  // namespace

HalfEdges half_edges(const Triangles& triangles, int vertex_count) {
  HalfEdges surface;
  surface.triangles = triangles;
  surface.outgoing.assign(static_cast<std::size_t>(vertex_count), -1);
  surface.opposite = opposite_half_edges(surface);
  for (int h = 0; h < surface.count(); ++h) {
    int& outgoing = surface.outgoing[static_cast<std::size_t>(surface.from(h))];
    if (outgoing < 0 || surface.on_boundary(h)) outgoing = h;
  }
  return surface;
}

std::vector<std::vector<int>> boundary_half_edges(const HalfEdges& surface) {
  std::vector<std::vector<int>> loops;
  std::vector<char> seen(surface.opposite.size(), 0);
  for (int start = 0; start < surface.count(); ++start) {
    if (!surface.on_boundary(start) || seen[static_cast<std::size_t>(start)]) continue;
    std::vector<int>& loop = loops.emplace_back();
    for (int h = start; !seen[static_cast<std::size_t>(h)];
         h = surface.outgoing[static_cast<std::size_t>(surface.to(h))]) {
      seen[static_cast<std::size_t>(h)] = 1;
      loop.push_back(h);
    }
  }
  return loops;
}

void mark(const HalfEdges& surface, EdgeMarks& marks, int h, bool value) {
  marks[static_cast<std::size_t>(h)] = value;
  const int other = surface.opposite[static_cast<std::size_t>(h)];
  if (other >= 0) marks[static_cast<std::size_t>(other)] = value;
}

Opened open_along(const HalfEdges& surface, const EdgeMarks& marks) {
  Opened opened{surface, std::vector<int>(static_cast<std::size_t>(surface.vertex_count()))};
  std::iota(opened.previous_vertex.begin(), opened.previous_vertex.end(), 0);
  std::vector<int> vertices;
  for (int h = 0; h < surface.count(); ++h)
    if (marks[static_cast<std::size_t>(h)]) {
      opened.surface.opposite[static_cast<std::size_t>(h)] = -1;
      vertices.push_back(surface.from(h));
      vertices.push_back(surface.to(h));
    }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const int vertex : vertices) open_vertex(surface, marks, vertex, opened);
  return opened;
}

void unmark_lone_edges(const HalfEdges& surface, EdgeMarks& marks) {
  std::vector<int> degree(surface.outgoing.size(), 0);
  const auto degree_of = [&](int v) -> int& { return degree[static_cast<std::size_t>(v)]; };
  for (int h = 0; h < surface.count(); ++h)
    if (surface.stands_for_edge(h) && (marks[static_cast<std::size_t>(h)] || surface.on_boundary(h))) {
      ++degree_of(surface.from(h));
      ++degree_of(surface.to(h));
    }
  for (int h = 0; h < surface.count(); ++h)
    if (marks[static_cast<std::size_t>(h)] && degree_of(surface.from(h)) == 1 &&
        degree_of(surface.to(h)) == 1)
      mark(surface, marks, h, false);
}

}  // namespace isostretch::mesh

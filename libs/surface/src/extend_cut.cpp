#include "cuttable.hpp"
#include "shortest_paths.hpp"
#include "spur.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace isostretch::mesh {
namespace {

[[noreturn]] void cannot_extend(int vertex, const char* why) {
  throw Error("cannot extend the cut from vertex " + std::to_string(vertex) + ": it " + why);
}

int chart_of_vertex(const Cut& cut, int vertex) {
  for (Eigen::Index i = 0; i < cut.mesh.triangles.size(); ++i)
    if (cut.mesh.triangles.data()[i] == vertex) return cut.chart[static_cast<std::size_t>(i / 3)];
  cannot_extend(vertex, "belongs to no triangle");
}

Part part_of_chart(const Cut& cut, int chart) {
  std::vector<int> label(cut.chart.size());
  for (std::size_t t = 0; t < label.size(); ++t) label[t] = cut.chart[t] == chart ? 0 : 1;
  return split({cut.mesh.vertices, cut.mesh.triangles, {}, {}}, label).front();
}

// An end moved by one edge only moves what it does to its neighbours.
constexpr int least_onward = 2;

// Where a cut ends inside the surface: both boundary edges are copies of one edge. `original` has the
// vertices of which those of the piece are copies.
bool is_end(const Piece& piece, const std::vector<int>& original, int vertex) {
  int first = -1, last = -1;
  for_each_neighbour(piece.surface, vertex, [&](int, int neighbour) {
    if (first < 0) first = neighbour;
    last = neighbour;
  });
  return original[at(first)] == original[at(last)];
}

int other_end(const HalfEdges& surface, int h, int vertex) {
  return surface.from(h) == vertex ? surface.to(h) : surface.from(h);
}

// Of every vertex, its distance from the boundary.
std::vector<double> depths(const Piece& piece) {
  std::vector<int> boundary;
  for (const std::vector<int>& loop : piece.loops)
    for (const int h : loop) boundary.push_back(piece.surface.from(h));
  return shortest_paths(piece.surface, piece.weights, boundary).distance;
}

// Edges at the last few vertices before an end of the cut are made long: a path to there would leave a spur.
std::vector<double> weights_around_ends(const Piece& piece, const std::vector<int>& original) {
  constexpr double detour = 1e3;
  std::vector<char> avoided(piece.surface.outgoing.size(), 0);
  for (const std::vector<int>& loop : piece.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (is_end(piece, original, piece.surface.from(loop[i])))
        for (std::size_t step = 1; step < at(least_branch); ++step)
          for (const std::size_t j : {i + step, i + loop.size() - step % loop.size()})
            avoided[at(piece.surface.from(loop[j % loop.size()]))] = 1;
  std::vector<double> weights = piece.weights;
  for (int h = 0; h < piece.surface.count(); ++h)
    for (const int v : {piece.surface.from(h), piece.surface.to(h)})
      if (avoided[at(v)] && !is_end(piece, original, v)) weights[at(h)] *= detour;
  return weights;
}

// From the vertex to the boundary, in half-edges of the piece. Ends of cuts attract: to go on from one makes
// no branch.
std::vector<int> path_to_boundary(const Piece& piece, const std::vector<int>& original, int vertex) {
  double typical = 0;
  for (const double weight : piece.weights) typical += weight / static_cast<double>(piece.weights.size());
  const double detour = least_branch * typical;
  double shortest = std::numeric_limits<double>::infinity();
  int best = -1;
  const ShortestPaths paths = shortest_paths(
      piece.surface, weights_around_ends(piece, original), {vertex}, [&](int v, double distance) {
        if (distance >= shortest) return true;
        if (!piece.surface.boundary_vertex(v)) return false;
        const double length = distance + (is_end(piece, original, v) ? 0 : detour);
        if (length < shortest) shortest = length, best = v;
        return false;
      });
  // What comes to the boundary on the way ends there.
  std::vector<int> path;
  std::vector<int> back = paths.path(piece.surface, best);
  for (int v = vertex; !piece.surface.boundary_vertex(v); back.pop_back()) {
    path.push_back(back.back());
    v = other_end(piece.surface, back.back(), v);
  }
  return path;
}

// The path, and beyond the vertex, away from the boundary, what it takes to be long enough.
std::vector<int> branch(const Piece& piece, const std::vector<int>& original, int vertex) {
  std::vector<int> path = path_to_boundary(piece, original, vertex);
  std::vector<char> on_path(piece.surface.outgoing.size(), 0);
  on_path[at(vertex)] = 1;
  int last = vertex;
  for (const int h : path) on_path[at(last = other_end(piece.surface, h, last))] = 1;
  const int least = is_end(piece, original, last) ? least_onward : least_branch;
  if (static_cast<int>(path.size()) >= least) return path;
  const std::vector<double> depth = depths(piece);
  while (static_cast<int>(path.size()) < least) {
    int deepest = vertex, edge = -1;
    for_each_neighbour(piece.surface, vertex, [&](int h, int neighbour) {
      if (!on_path[at(neighbour)] && depth[at(neighbour)] > depth[at(deepest)]) deepest = neighbour, edge = h;
    });
    if (edge < 0) break;
    path.push_back(edge);
    on_path[at(vertex = deepest)] = 1;
  }
  return path;
}

void note_seam(Cut& cut, int chart, int a, int b) {
  const auto [low, high] = std::minmax({cut.original_vertex[at(a)], cut.original_vertex[at(b)]});
  const Edge edge{low, high};
  cut.seams.insert(std::lower_bound(cut.seams.begin(), cut.seams.end(), edge), edge);
  cut.charts[at(chart)].seam_length += length(edge_vector(cut.mesh.vertices, a, b));
}

// Numbers the copies in the whole mesh. Returns for its vertices what they were.
std::vector<int> put_back(const Opened& opened, const Part& part, Cut& cut) {
  const auto V = static_cast<int>(cut.mesh.vertices.rows());
  const auto kept = static_cast<int>(part.original_vertex.size());
  const int copies = opened.surface.vertex_count() - kept;
  std::vector<int> previous(at(V + copies));
  std::iota(previous.begin(), previous.begin() + V, 0);
  cut.mesh.vertices.conservativeResize(V + copies, 3);
  for (int i = 0; i < copies; ++i) {
    const int copied = part.original_vertex[at(opened.previous_vertex[at(kept + i)])];
    previous[at(V + i)] = copied;
    cut.mesh.vertices.row(V + i) = cut.mesh.vertices.row(copied);
    cut.original_vertex.push_back(cut.original_vertex[at(copied)]);
  }
  for (int h = 0; h < opened.surface.count(); ++h) {
    const int v = opened.surface.from(h);
    cut.mesh.triangles(part.original_triangle[at(h / 3)], h % 3) =
        v < kept ? part.original_vertex[at(v)] : V + v - kept;
  }
  return previous;
}

}  // namespace

std::vector<int> extend_cut(Cut& cut, int vertex) {
  if (vertex < 0 || vertex >= cut.mesh.vertices.rows()) cannot_extend(vertex, "does not exist");
  const int chart = chart_of_vertex(cut, vertex);
  const Part part = part_of_chart(cut, chart);
  const Piece piece = make_piece(part.mesh);
  const auto& known = part.original_vertex;
  const auto local = static_cast<int>(std::lower_bound(known.begin(), known.end(), vertex) - known.begin());
  if (piece.surface.boundary_vertex(local)) cannot_extend(vertex, "is on the boundary already");
  EdgeMarks marks(piece.surface.opposite.size(), 0);
  std::vector<int> original;
  for (const int v : known) original.push_back(cut.original_vertex[at(v)]);
  for (const int h : branch(piece, original, local)) {
    mark(piece.surface, marks, h);
    note_seam(cut, chart, known[at(piece.surface.from(h))], known[at(piece.surface.to(h))]);
  }
  return put_back(open_along(piece.surface, marks), part, cut);
}

}  // namespace isostretch::mesh

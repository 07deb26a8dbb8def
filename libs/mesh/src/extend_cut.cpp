#include "cuttable.hpp"
#include "measure.hpp"
#include "shortest_paths.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/components.hpp>
#include <isostretch/mesh/cut.hpp>

#include <algorithm>
#include <numeric>
#include <string>

namespace isostretch::mesh {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

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

// From the boundary inward, in half-edges of the piece.
std::vector<int> path_to_boundary(const Piece& piece, int vertex) {
  const ShortestPaths paths = shortest_paths(piece.surface, piece.weights, {vertex},
                                             [&](int v, double) { return piece.surface.boundary_vertex(v); });
  return paths.path(piece.surface, paths.last);
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
  for (const int h : path_to_boundary(piece, local)) {
    mark(piece.surface, marks, h);
    note_seam(cut, chart, known[at(piece.surface.from(h))], known[at(piece.surface.to(h))]);
  }
  return put_back(open_along(piece.surface, marks), part, cut);
}

}  // namespace isostretch::mesh

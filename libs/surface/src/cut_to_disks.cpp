#include "cuttable.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/index.hpp>
#include <isostretch/mesh/gather.hpp>
#include <isostretch/mesh/measure.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace isostretch::mesh {
namespace {

Edge edge_of(const HalfEdges& surface, int h) {
  const auto [low, high] = std::minmax({surface.from(h), surface.to(h)});
  return {low, high};
}

EdgeMarks given_seams(const HalfEdges& surface, const std::vector<Edge>& seams) {
  EdgeMarks marks(at(surface.count()), 0);
  for (const Edge& seam : seams) {
    int found = -1;
    if (seam.low >= 0 && seam.low < surface.vertex_count() && surface.outgoing[at(seam.low)] >= 0)
      for_each_neighbour(surface, seam.low, [&](int h, int neighbour) {
        if (neighbour == seam.high) found = h;
      });
    if (found < 0)
      throw Error("the seam " + std::to_string(seam.low) + "-" + std::to_string(seam.high) +
                  " is no edge of the mesh");
    if (!surface.on_boundary(found)) mark(surface, marks, found);
  }
  unmark_lone_edges(surface, marks);
  return marks;
}

std::vector<char> loops_below(const Piece& piece, double length) {
  std::vector<char> below;
  for (const double loop : piece.loop_lengths) below.push_back(loop < length);
  return below;
}

double longest_loop(const Piece& piece) {
  return piece.loop_lengths.empty() ? 0
                                    : *std::max_element(piece.loop_lengths.begin(), piece.loop_lengths.end());
}

// Holes are short against the longest loop, or against the one that opening the handles makes.
EdgeMarks cut_keeping_short(const Piece& piece, double fraction) {
  double reference = longest_loop(piece);
  if (piece.genus > 0) {
    std::vector<char> all(piece.loops.size(), 1);
    EdgeMarks graph = cut_graph(piece, all);
    reference = std::max(reference, 2 * marked_weight(piece.surface, graph, piece.weights));
    if (longest_loop(piece) < fraction * reference) return graph;
  }
  std::vector<char> kept = loops_below(piece, fraction * reference);
  return cut_graph(piece, kept);
}

EdgeMarks cut_piece(const Piece& piece, const CutOptions& options) {
  if (piece.loops.empty() && piece.genus == 0)
    return cut_tree(piece, options.max_terminals, options.terminal_distance);
  if (piece.loops.size() == 1 && piece.genus == 0) return EdgeMarks(piece.surface.opposite.size(), 0);
  if (options.holes == Holes::keep_short) return cut_keeping_short(piece, options.hole_fraction);
  std::vector<char> kept(piece.loops.size(), 0);
  if (options.holes == Holes::keep_all)
    kept = piece.genus > 0 ? std::vector<char>(kept.size(), 1) : loops_below(piece, longest_loop(piece));
  return cut_graph(piece, kept);
}

// Cuts what the given seams leave, piece by piece; every piece is a chart.
void cut_charts(const SurfaceMesh& mesh, const HalfEdges& surface, const CutOptions& options,
                EdgeMarks& marks, Cut& cut) {
  const Opened opened = open_along(surface, marks);
  const std::vector<int> component = component_of_triangles(mesh.triangles, surface.vertex_count());
  std::vector<char> closed(at(1 + *std::max_element(component.begin(), component.end())), 1);
  for (int h = 0; h < surface.count(); ++h)
    if (surface.on_boundary(h)) closed[at(component[at(h / 3)])] = 0;
  cut.chart = component_of_triangles(opened.surface.triangles, opened.surface.vertex_count());
  for (const Part& part :
       split({gather(mesh.vertices, opened.previous_vertex), opened.surface.triangles, {}, {}}, cut.chart)) {
    const Piece piece = make_piece(part.mesh);
    EdgeMarks cuts = cut_piece(piece, options);
    if (closed[at(component[at(part.original_triangle.front())])])
      reach_tips(piece, part.mesh.vertices, options.max_terminals - 2, options.tip_scale, cuts);
    for (int h = 0; h < piece.surface.count(); ++h)
      if (cuts[at(h)]) mark(surface, marks, 3 * part.original_triangle[at(h / 3)] + h % 3);
    Chart& chart = cut.charts.emplace_back();
    chart.component = component[at(part.original_triangle.front())];
    chart.triangles = static_cast<int>(part.mesh.triangles.rows());
    chart.area = piece.area;
    chart.genus = piece.genus;
    chart.loops_before = static_cast<int>(piece.loops.size());
  }
}

void describe_seams(const SurfaceMesh& mesh, const HalfEdges& surface, const EdgeMarks& marks, Cut& cut) {
  for (int h = 0; h < surface.count(); ++h) {
    if (!marks[at(h)] || !surface.stands_for_edge(h)) continue;
    cut.seams.push_back(edge_of(surface, h));
    const double size = length(edge_vector(mesh.vertices, surface.from(h), surface.to(h)));
    const int here = cut.chart[at(h / 3)], beyond = cut.chart[at(surface.opposite[at(h)] / 3)];
    cut.charts[at(here)].seam_length += size;
    if (beyond != here) cut.charts[at(beyond)].seam_length += size;
  }
  std::sort(cut.seams.begin(), cut.seams.end());
}

}  // namespace

Cut cut_to_disks(const SurfaceMesh& mesh, const CutOptions& options) {
  require_cuttable(mesh);
  const HalfEdges surface = half_edges(mesh.triangles, static_cast<int>(mesh.vertices.rows()));
  Cut cut;
  EdgeMarks marks = given_seams(surface, options.seams);
  cut_charts(mesh, surface, options, marks, cut);
  describe_seams(mesh, surface, marks, cut);
  Opened opened = open_along(surface, marks);
  for (Chart& chart : cut.charts) chart.loops = 0;
  for (const std::vector<int>& loop : boundary_half_edges(opened.surface))
    ++cut.charts[at(cut.chart[at(loop.front() / 3)])].loops;
  cut.mesh = {gather(mesh.vertices, opened.previous_vertex), std::move(opened.surface.triangles), mesh.uv,
              mesh.uv_triangles};
  cut.original_vertex = std::move(opened.previous_vertex);
  return cut;
}

}  // namespace isostretch::mesh

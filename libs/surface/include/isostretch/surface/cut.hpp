#pragma once

#include <isostretch/core/choice_names.hpp>
#include <isostretch/mesh/types.hpp>
#include <isostretch/surface/seams.hpp>

#include <memory>
#include <vector>

namespace isostretch::mesh {

struct TriangleGraph;

/// The treatment of boundary loops besides the longest: cut to it, or kept as holes of the chart.
enum class Holes {
  keep_short,  ///< Keeps those shorter than hole_fraction of the longest.
  cut_all,     ///< Keeps none: charts are disks.
  /// Keeps all.
  keep_all
};
/// Returns the names of the choices on the command line and in scenes.
constexpr ChoiceNames<Holes, 3> choice_names(Holes) {
  return {{{"short", Holes::keep_short}, {"none", Holes::cut_all}, {"all", Holes::keep_all}}};
}

/// The choices of cut_to_disks().
struct CutOptions {
  /// Edges to cut in any case; the charts that they make are cut further where needed.
  std::vector<Edge> seams = {};
  Holes holes = Holes::keep_short;  ///< Which boundary loops stay holes.
  /// Length of a hole against the longest boundary loop below which Holes::keep_short keeps it.
  double hole_fraction = 0.25;
  /// The number of far-apart vertices, at least 2, in which the cut of a closed surface of genus 0 may end.
  /// The cut is a tree; from the third end on, only vertices are taken whose distance from the tree is more
  /// than terminal_distance times the square root of the area.
  int max_terminals = 8;
  /// Distance of a further end from the tree, against the square root of the area.
  double terminal_distance = 0.35;
  /// The logarithm of the scale of a conformal map beyond which the cut goes on, to up to max_terminals - 2
  /// vertices of each piece of a closed component where that piece would be stretched or shrunk most.
  double tip_scale = 2.5;
};

/// A piece of the surface that the cut leaves connected.
struct Chart {
  int component = 0;       ///< Component of the input, as component_of_triangles() counts.
  int triangles = 0;       ///< Number of triangles.
  double area = 0;         ///< Sum of areas.
  int genus = 0;           ///< Handles before the cut, with the given seams open; they were cut.
  int loops_before = 0;    ///< Boundary loops before the cut, with the given seams open.
  int loops = 1;           ///< Boundary loops: 1 is a disk, more are holes that were kept.
  double seam_length = 0;  ///< Sum of edge lengths; an edge with the chart on both sides counts once.
};

/// A surface cut to charts, and the way back to the input.
struct Cut {
  SurfaceMesh mesh;                  ///< The triangles of the input in their order; uv is kept.
  std::vector<int> original_vertex;  ///< Vertex of the input of every vertex of the cut mesh.
  std::vector<int> chart;            ///< Chart of every triangle.
  std::vector<Chart> charts;         ///< In the order of their first triangles.
  std::vector<Edge> seams;           ///< Edges cut open, in the numbering of the input, ascending.
  /// Returns the seams as polylines, see seam_paths().
  std::vector<std::vector<int>> paths() const { return seam_paths(seams); }
};

/// Cuts an oriented manifold surface, of any genus and with any number of components and boundary loops,
/// until every component is a disk (or a disk with the holes that are kept). Vertices on the cut are copied;
/// a vertex keeps its number and its copies come last. Nothing is cut where it is not needed.
///
/// Handles are cut along the system of loops of Erickson and Whittlesey ("Greedy optimal homotopy and
/// homology generators", 2005), from the best of several base points, then path by path replaced by the
/// shortest that still opens the surface. Boundary loops are joined by shortest paths. Closed surfaces of
/// genus 0 are cut along a tree of shortest paths between the vertices farthest apart. Tips that this leaves
/// uncut are found by their curvature.
///
/// Where to cut is decided by geometry alone: numbering, scale and place of the mesh do not matter. A kept
/// hole that leaves no way for the cut around it is cut after all, as Chart::loops then says. A seam edge
/// that is on the boundary, or alone inside the surface, opens nothing and is left out.
///
/// Throws Error naming the element for a mesh that is not manifold, not orientable or not consistently
/// oriented, has duplicate or degenerate triangles or coordinates that are not finite, and for a seam that is
/// no edge.
Cut cut_to_disks(const SurfaceMesh& mesh, const CutOptions& options = {});

/// Lengthens the cut by a short path from a vertex of the cut mesh to the boundary of its chart, which stays
/// a disk. The path goes on from an end of the cut where one is about as near as the rest of the boundary;
/// where it branches off and would be a spur of less than four edges, it is continued beyond the vertex, away
/// from the boundary. Vertices keep their numbers and copies come last. Returns for every vertex of the new
/// cut mesh the vertex it was before, by which values at vertices are carried over. Throws Error when the
/// vertex is on the boundary already or in no triangle.
std::vector<int> extend_cut(Cut& cut, int vertex);

/// Returns the branches of a cut that are too short for a seam: fewer than four edges from an end inside the
/// surface to where they meet the rest of the cut or the boundary. Each is a path of vertices in the
/// numbering of the input, from its end on.
std::vector<std::vector<int>> spurs(const Cut& cut);

/// A part of a chart within a closed loop of edges, or within several.
struct Enclosure {
  std::vector<int> triangles;  ///< Triangles inside, ascending; none where there is no such loop.
  double length = 0;           ///< Length of the loop.
  double area = 0;             ///< Area inside.
};

/// A finder of the shortest loops of edges around triangles of a cut mesh, which must stay as it is
/// meanwhile.
class Encloser {
 public:
  /// Prepares the search in a cut mesh, which must outlive this object.
  explicit Encloser(const Cut& cut);
  ~Encloser();
  Encloser(const Encloser&) = delete;
  Encloser& operator=(const Encloser&) = delete;

  /// Returns the part of a chart within the shortest loop around the given triangles that keeps off the
  /// boundary of the chart. There is no such loop where one of the triangles has an edge on the boundary; a
  /// loop of length `limit` or more is not looked for. Throws Error for triangles that do not exist or are of
  /// several charts.
  Enclosure enclose(const std::vector<int>& triangles, double limit) const;

 private:
  const Cut& cut_;
  std::unique_ptr<const TriangleGraph> graph_;
};

/// The way back from a cut whose charts were divided.
struct Division {
  /// Vertex before of every vertex of the new cut mesh, by which values are carried over.
  std::vector<int> previous_vertex;
  std::vector<int> previous_chart;  ///< Chart that every chart was part of.
};

/// Divides charts along the edges between triangles of different parts. `part` has a number for every
/// triangle, counted from 0 in the order of their first triangles; a part lies in one chart and becomes one.
/// Vertices keep their numbers and copies come last; nothing moves. Throws Error when a triangle has no
/// number or parts are not counted so.
Division divide_charts(Cut& cut, const std::vector<int>& part);

/// Divides the charts that lie on themselves in a layout until none does. `uv` has a row for every vertex of
/// the cut mesh; charts may lie on each other. Parts of a chart that overlap are separated by the shortest
/// way between them along edges, and parts that no longer overlap are joined again. Nothing has to be solved
/// anew: triangles keep their shapes. Throws Error for coordinates that are not finite.
Division split_overlap(Cut& cut, const Points2& uv);

}  // namespace isostretch::mesh

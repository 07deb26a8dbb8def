#pragma once

#include <isostretch/mesh/types.hpp>
#include <isostretch/surface/seams.hpp>

#include <memory>
#include <vector>

namespace isostretch::mesh {

struct TriangleGraph;

/// Boundary loops besides the longest: cut to it, or kept as holes of the chart.
enum class Holes {
  keep_short,  ///< those shorter than hole_fraction of the longest are kept
  cut_all,     ///< charts are disks
  keep_all
};

struct CutOptions {
  std::vector<Edge> seams = {};  ///< edges to cut in any case; charts they make are cut further where needed
  Holes holes = Holes::keep_short;
  double hole_fraction = 0.25;
  /// Of closed surfaces of genus 0: the cut is a tree that ends in up to this many far-apart vertices (at
  /// least 2). From the third on only those are taken whose distance from the tree is more than
  /// terminal_distance times the square root of the area.
  int max_terminals = 8;
  double terminal_distance = 0.35;
  /// Where pieces of a closed component would be stretched or shrunk most, the cut goes on: to up to
  /// max_terminals - 2 vertices of each at which the logarithm of the scale of a conformal map is more than
  /// this.
  double tip_scale = 2.5;
};

/// A piece of the surface that the cut leaves connected.
struct Chart {
  int component = 0;  ///< of the input, as component_of_triangles counts
  int triangles = 0;
  double area = 0;
  int genus = 0;           ///< before the cut, with the given seams open: its handles were cut
  int loops_before = 0;    ///< boundary loops, the same
  int loops = 1;           ///< now: 1 is a disk, more are holes that were kept
  double seam_length = 0;  ///< an edge with the chart on both sides counts once
};

struct Cut {
  SurfaceMesh mesh;                  ///< the same triangles in the same order; uv is kept
  std::vector<int> original_vertex;  ///< vertex of the cut mesh -> vertex of the input
  std::vector<int> chart;            ///< of every triangle
  std::vector<Chart> charts;         ///< in the order of their first triangles
  std::vector<Edge> seams;           ///< edges cut open, in the input's numbering, ascending
  /// The same as polylines, see seam_paths.
  std::vector<std::vector<int>> paths() const { return seam_paths(seams); }
};

/// Cuts an oriented manifold surface, of any genus and with any number of components and boundary loops,
/// until every component is a disk (or a disk with the holes that are kept). Vertices on the cut are copied;
/// a vertex keeps its number and its copies come last. Nothing is cut where it is not needed.
///
/// Handles: the system of loops of Erickson & Whittlesey ("Greedy optimal homotopy and homology generators",
/// 2005), from the best of several base points, then path by path replaced by the shortest that still opens
/// the surface. Boundary loops: shortest paths. Closed surfaces of genus 0: a tree of shortest paths between
/// the vertices farthest apart. Tips that this leaves uncut are found by their curvature.
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

/// Lists the branches of a cut that are too short for a seam: fewer than four edges from an end inside the
/// surface to where they meet the rest of the cut or the boundary. Each is a path of vertices in the input's
/// numbering, from its end on.
std::vector<std::vector<int>> spurs(const Cut& cut);

/// A part of a chart within a closed loop of edges, or within several.
struct Enclosure {
  std::vector<int> triangles;  ///< inside, ascending; none where there is no such loop
  double length = 0;           ///< of the loop
  double area = 0;             ///< inside
};

/// Finds the shortest loops of edges around triangles of a cut mesh, which must stay as it is meanwhile.
class Encloser {
 public:
  explicit Encloser(const Cut& cut);
  ~Encloser();
  Encloser(const Encloser&) = delete;
  Encloser& operator=(const Encloser&) = delete;

  /// Encloses triangles of one chart by the shortest loop that keeps off its boundary.
  ///
  /// There is none where one of the triangles has an edge on the boundary, and one of `limit` or more in
  /// length is not looked for. Throws Error for triangles that do not exist or are of several charts.
  Enclosure enclose(const std::vector<int>& triangles, double limit) const;

 private:
  const Cut& cut_;
  std::unique_ptr<const TriangleGraph> graph_;
};

/// What became of a cut whose charts were divided.
struct Division {
  std::vector<int>
      previous_vertex;  ///< vertex of the new cut mesh -> vertex before, by which values are carried
  std::vector<int> previous_chart;  ///< chart now -> chart it was part of
};

/// Divides charts along the edges between triangles of different parts.
///
/// `part` has a number for every triangle, counted from 0 in the order of their first triangles; a part lies
/// in one chart and becomes one. Vertices keep their numbers and copies come last; nothing moves. Throws
/// Error when a triangle has no number or parts are not counted so.
Division divide_charts(Cut& cut, const std::vector<int>& part);

/// Divides the charts that lie on themselves in a layout until none does.
///
/// `uv` has a row for every vertex of the cut mesh; charts may lie on each other. Parts of a chart that
/// overlap are separated by the shortest way between them along edges, and parts that no longer overlap are
/// joined again. Nothing has to be solved anew: triangles keep their shapes. Throws Error for coordinates
/// that are not finite.
Division split_overlap(Cut& cut, const Points2& uv);

}  // namespace isostretch::mesh

#pragma once

#include <isostretch/mesh/types.hpp>
#include <isostretch/sparse/options.hpp>

#include <string>
#include <vector>

namespace isostretch::parameterization {

/// The shape on which the boundary of Tutte's embedding lies.
enum class BoundaryShape { circle, square };

/// The weights of the edges inside; positive always, which is what keeps triangles from flipping.
enum class EdgeWeights {
  /// All weights are 1.
  uniform,
  cotangent,  ///< Cotangents of the angles opposite, at least 1e-3: keeps the shape of needles.
};

/// The choices of tutte_embedding().
struct TutteOptions {
  BoundaryShape boundary = BoundaryShape::circle;  ///< Shape of the boundary.
  /// Four vertices of the boundary, in its order, that become the corners of the square, the first one at the
  /// lower left. Where there are none, these are the boundary vertex farthest from the middle of the
  /// boundary, and those that come nearest to quarters of its length.
  std::vector<int> corners;

  EdgeWeights weights = EdgeWeights::uniform;  ///< Weights of the edges inside.
  /// The largest number of further solves in which the weights of edges are multiplied by how small the
  /// triangles around came out. Any weights shrink what lies far behind a narrow neck so much that triangles
  /// collapse in floating point; any positive weights give an embedding without flips in exact arithmetic. 0
  /// solves once.
  int max_reweightings = 60;
  /// The factor by which areas may come out too small on average before weights are changed although there
  /// are no flips, since a minimisation would need long to undo that.
  double acceptable_collapse = 1e6;

  sparse::Options solver;  ///< The linear solver.
};

/// The end of tutte_embedding().
enum class TutteStatus {
  /// There is a layout without flips.
  ok,
  flipped,  ///< Triangles collapsed or turned over: they came out smaller than floating point can tell apart.
  failed    ///< The linear solver failed; uv is empty.
};

/// A layout by Tutte's embedding.
struct TutteResult {
  TutteStatus status = TutteStatus::ok;  ///< How it ended.
  std::string message;                   ///< Description of a failure, empty when ok.
  mesh::Points2 uv;                      ///< V x 2, one row per vertex of the mesh.
  std::vector<int> flipped;              ///< Triangles that are not positively oriented.
  /// Changes of weights behind uv, the solution with the fewest flips, then the smallest collapse.
  int reweightings = 0;
};

/// Returns Tutte's embedding ("How to draw a graph", 1963; Floater 1997) of a topological disk: the boundary
/// on a circle or square with the spacing of its edge lengths, every interior vertex the mean of its
/// neighbours, weighted where uniform weights collapse triangles (as Yoshizawa, Belyaev and Seidel 2004 do to
/// reduce stretch). It is scaled so that the area of uv is 1, and centred at the origin; triangles are
/// counter-clockwise. Throws Error when the mesh is not a disk (mesh::require_disk()) or has a coordinate
/// that is not finite, and for corners that are not four different boundary vertices in order.
TutteResult tutte_embedding(const mesh::SurfaceMesh& mesh, const TutteOptions& options = {});

/// Returns the mesh with every boundary loop but the longest closed by a fan around a new vertex at its
/// centre. New vertices and triangles come last: an embedding of the result, cut off there, is one of the
/// mesh. uv is left out. Throws Error as mesh::boundary_loops() does.
mesh::SurfaceMesh fill_holes(const mesh::SurfaceMesh& mesh);

}  // namespace isostretch::parameterization

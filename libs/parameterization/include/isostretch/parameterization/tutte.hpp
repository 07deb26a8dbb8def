#pragma once

#include <isostretch/mesh/types.hpp>
#include <isostretch/sparse/options.hpp>

#include <string>
#include <vector>

namespace isostretch::parameterization {

enum class BoundaryShape { circle, square };

/// Of the edges inside; positive always, which is what keeps triangles from flipping.
enum class EdgeWeights {
  uniform,
  cotangent,  ///< of the angles opposite, at least 1e-3: keeps the shape of needles
};

struct TutteOptions {
  BoundaryShape boundary = BoundaryShape::circle;
  /// Of the square: four vertices of the boundary in its order, the first one at the lower left. Empty: the
  /// boundary vertex farthest from the middle of the boundary, and those that come nearest to quarters of its
  /// length.
  std::vector<int> corners;

  EdgeWeights weights = EdgeWeights::uniform;
  /// Any weights shrink what lies far behind a narrow neck so much that triangles collapse in floating
  /// point. Weights of edges are then multiplied by how small the triangles around came out, and the system
  /// is solved again, up to this often (0: never). Any positive weights give an embedding without flips in
  /// exact arithmetic. So it is done without flips where areas come out that many times too small on average,
  /// which a minimisation would need long to undo.
  int max_reweightings = 60;
  double acceptable_collapse = 1e6;

  sparse::Options solver;
};

enum class TutteStatus {
  ok,
  flipped,  ///< triangles collapsed or turned over: they came out smaller than floating point can tell apart
  failed    ///< the linear solver failed; uv is empty
};

struct TutteResult {
  TutteStatus status = TutteStatus::ok;
  std::string message;       ///< empty when ok
  mesh::Points2 uv;          ///< #V x 2, one per vertex of the mesh
  std::vector<int> flipped;  ///< triangles that are not positively oriented
  int reweightings = 0;      ///< behind uv, the solution with the fewest flips, then the smallest collapse
};

/// Tutte's embedding ("How to draw a graph", 1963; Floater 1997) of a topological disk: the boundary on a
/// circle or square with the spacing of its edge lengths, every interior vertex the mean of its neighbours,
/// weighted where uniform weights collapse triangles (as Yoshizawa, Belyaev & Seidel 2004 do to reduce
/// stretch). Scaled so that the area of uv is 1, centred at the origin; triangles counter-clockwise. Throws
/// Error when the mesh is not a disk (require_disk) or has a coordinate that is not finite, and for corners
/// that are not four different boundary vertices in order.
TutteResult tutte_embedding(const mesh::SurfaceMesh& mesh, const TutteOptions& options = {});

/// The mesh with every boundary loop but the longest closed by a fan around a new vertex at its centre. New
/// vertices and triangles come last: an embedding of the result, cut off there, is one of the mesh. uv is
/// left out. Throws Error like boundary_loops().
mesh::SurfaceMesh fill_holes(const mesh::SurfaceMesh& mesh);

}  // namespace isostretch::parameterization

#pragma once

#include <isostretch/mesh/types.hpp>
#include <isostretch/sparse/options.hpp>

#include <string>
#include <vector>

namespace isostretch::mesh {

struct TutteOptions {
  sparse::Options solver;
};

enum class TutteStatus {
  ok,
  flipped,  // triangles collapsed or turned over: they came out smaller than floating point can tell apart
  failed    // the linear solver failed; uv is empty
};

struct TutteResult {
  TutteStatus status = TutteStatus::ok;
  std::string message;       // empty when ok
  Points2 uv;                // #V x 2, one per vertex of the mesh
  std::vector<int> flipped;  // triangles that are not positively oriented
};

// Tutte's embedding ("How to draw a graph", 1963; Floater 1997) of a topological disk: the boundary on a
// circle with the spacing of its edge lengths, every interior vertex the mean of its neighbours. Scaled so
// that the area of uv is 1, centred at the origin; triangles counter-clockwise. Throws Error when the mesh is
// not a disk (require_disk) or has a coordinate that is not finite.
TutteResult tutte_embedding(const SurfaceMesh& mesh, const TutteOptions& options = {});

}  // namespace isostretch::mesh

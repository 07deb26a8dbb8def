#pragma once

#include "options.hpp"

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::app::parameterize {

// What is flattened: the input, opened where it has to be.
struct Domain {
  mesh::SurfaceMesh input;  // as read; uv only when it is the start
  mesh::SurfaceMesh open;   // the same triangles in the same order; a vertex on a cut has several copies
  std::vector<int> original_vertex;  // vertex of `open` -> vertex of `input`
  mesh::Points2 input_uv;            // per vertex of `open`, when the input's uv is the start
  int boundary_loops = 0;            // of the input
  int cut_edges = 0;                 // along the path that opened a closed surface
};

// Throw Failure: ExitCode::input naming file and element for what cannot be read or is not a disk.
Domain read_domain(const Options& options);

// The vertex of `open` that a vertex of the input is; ExitCode::command_line when it does not exist or a cut
// has made several of it. `option` is what asked, for the message.
int open_vertex(const Domain& domain, int input_vertex, const char* option);

}  // namespace isostretch::app::parameterize

#pragma once

#include "options.hpp"

#include <isostretch/mesh/types.hpp>
#include <isostretch/mesh_io/obj_document.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/repair.hpp>

#include <memory>
#include <string>
#include <vector>

namespace isostretch::app::parameterize {

// What is flattened: the input, repaired where that was asked for, and opened where it has to be.
struct Domain {
  mesh::SurfaceMesh input;
  std::shared_ptr<const mesh::ObjDocument> document;  // of an OBJ file: what input was made of
  mesh::RepairReport repairs;                         // empty without --repair
  // Opened: the same triangles in the same order, a vertex on a seam has several copies.
  mesh::Cut cut;
  mesh::Points2 input_uv;  // per vertex of cut.mesh, when the input's uv is the start
  int components = 0;      // of the input
  int boundary_loops = 0;
  bool closed = false;  // no component has a boundary
  int genus = -1;       // summed over components; -1: not defined
  bool seams_from_input = false;

  const mesh::SurfaceMesh& open() const { return cut.mesh; }
};

// The input, repaired where that was asked for, and all that mesh::check() says about it. Throws Failure
// (ExitCode::input) only for what cannot be read.
std::string check_report(const Options& options, bool& clean);

// Throws Failure: ExitCode::input naming file and element for what cannot be read or flattened.
Domain read_domain(const Options& options);

// The rows of a layout that are listed, in that order: of a chart's vertices, or of copies that a cut has
// made.
mesh::Points2 rows_of(const mesh::Points2& uv, const std::vector<int>& rows);

// The vertex of the opened mesh that a vertex of the input is; ExitCode::command_line when it does not exist
// or a seam has made several of it. `option` is what asked, for the message.
int open_vertex(const Domain& domain, int input_vertex, const char* option);

}  // namespace isostretch::app::parameterize

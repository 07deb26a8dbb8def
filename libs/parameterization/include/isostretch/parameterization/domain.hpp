#pragma once

#include <isostretch/mesh/types.hpp>
#include <isostretch/parameterization/options.hpp>
#include <isostretch/surface/cut.hpp>

#include <string>
#include <vector>

namespace isostretch::parameterization {

/// What is flattened: the model, opened where it has to be.
struct Domain {
  mesh::SurfaceMesh input;
  /// Opened: the same triangles in the same order, a vertex on a seam has several copies.
  mesh::Cut cut;
  mesh::Points2 input_uv;  ///< per vertex of cut.mesh, when the input's uv is the start
  int components = 0;      ///< of the input
  int boundary_loops = 0;
  bool closed = false;  ///< no component has a boundary
  int genus = -1;       ///< summed over components; -1: not defined
  bool seams_from_input = false;

  const mesh::SurfaceMesh& open() const { return cut.mesh; }
};

/// Opens the model: along the seams of its texture coordinates, or by cutting it to disks, as the options
/// say. Throws Error naming the element for what cannot be flattened, and OptionError for options that do not
/// go with it.
Domain make_domain(const mesh::SurfaceMesh& model, const Options& options);

/// The rows of a layout that are listed, in that order: of a chart's vertices, or of copies that a cut has
/// made.
mesh::Points2 rows_of(const mesh::Points2& uv, const std::vector<int>& rows);

/// Returns the vertex of the opened mesh that a vertex of the model is. Throws OptionError for `option`,
/// which asked, when there is none or a seam has made several of it.
int open_vertex(const Domain& domain, int input_vertex, const char* option);

}  // namespace isostretch::parameterization

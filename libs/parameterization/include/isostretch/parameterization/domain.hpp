#pragma once

#include <isostretch/mesh/types.hpp>
#include <isostretch/parameterization/options.hpp>
#include <isostretch/surface/cut.hpp>

#include <string>
#include <vector>

namespace isostretch::parameterization {

/// The surface that is flattened, opened where it has to be.
struct Domain {
  mesh::SurfaceMesh input;  ///< The surface before it is opened.
  /// The opened surface: the same triangles in the same order; a vertex on a seam has several copies.
  mesh::Cut cut;
  /// Texture coordinates per vertex of the opened mesh, where those of the input are the start.
  mesh::Points2 input_uv;
  int components = 0;             ///< Components of the input.
  int boundary_loops = 0;         ///< Boundary loops of the input.
  bool closed = false;            ///< Whether no component has a boundary.
  int genus = -1;                 ///< Sum of handles over components, -1 where it is not defined.
  bool seams_from_input = false;  ///< Whether the seams are those of the input's texture coordinates.

  /// Returns the opened mesh.
  const mesh::SurfaceMesh& open() const { return cut.mesh; }
};

/// Opens a surface along the seams of its texture coordinates, or by cutting it to disks, as the options say.
/// Throws Error naming the element for a surface that cannot be flattened, and OptionError for options that
/// do not go with it.
Domain make_domain(const mesh::SurfaceMesh& model, const Options& options);

/// Returns the listed rows of a layout, in the order of the list, such as those of a chart's vertices or of
/// copies that a cut has made.
mesh::Points2 rows_of(const mesh::Points2& uv, const std::vector<int>& rows);

/// Returns the vertex of the opened mesh that a vertex of the model is. Throws OptionError about `option`,
/// which asked, when there is none or a seam has made several of it.
int open_vertex(const Domain& domain, int input_vertex, const char* option);

}  // namespace isostretch::parameterization

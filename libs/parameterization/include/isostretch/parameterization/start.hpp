#pragma once

#include <isostretch/core/stop_token.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/parameterization/tutte.hpp>
#include <isostretch/parameterization/untangle.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::parameterization {

/// The means by which a start became free of flips.
enum class StartMethod {
  uniform,  ///< Tutte's embedding as it is.
  /// Tutte's embedding with weights that keep triangles from collapsing, or a flat chart as it lies.
  weighted,
  untangled  ///< Untangling of the flips that were left.
};

/// Returns the name of the enumerator, such as "untangled".
std::string_view start_method_name(StartMethod method) noexcept;

/// The choices of flip_free_start().
struct StartOptions {
  parameterization::TutteOptions tutte;  ///< Choices of Tutte's embedding.
  bool keep_boundary = false;  ///< Whether untangling leaves the boundary where Tutte's embedding has it.
  UntangleOptions untangle;    ///< Choices of untangling.
  StopToken stop;              ///< Asked now and then; a request to stop ends the work with what there is.
};

/// A layout to start from, and how it was found.
struct StartResult {
  mesh::Points2 uv;                           ///< V x 2; empty when the linear solver failed.
  StartMethod method = StartMethod::uniform;  ///< How the layout was made free of flips.
  std::vector<int> flipped;                   ///< Triangles still collapsed or turned over; none is success.
  std::string message;                        ///< Description of a failure, otherwise empty.
  int reweightings = 0;                       ///< Solves of Tutte's embedding with changed weights.
  UntangleResult untangling;                  ///< Result of untangling.
  /// Returns whether there is a layout without flips.
  bool ok() const { return uv.rows() > 0 && flipped.empty(); }
};

/// Returns a layout without flips of a chart, a disk or a disk with holes, to start a minimisation from:
/// Tutte's embedding with the holes closed for the time being, at the area that `rest` has (the chart's
/// triangles, see mesh::flat_elements()). Where floating point collapses triangles their weights are raised,
/// and the flips that are left are untangled. Throws Error when the mesh is not such a chart.
StartResult flip_free_start(const mesh::SurfaceMesh& chart, const mesh::ElementArrays& rest,
                            const StartOptions& options = {});

}  // namespace isostretch::parameterization

#pragma once

#include <isostretch/core/stop_token.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/parameterization/tutte.hpp>
#include <isostretch/parameterization/untangle.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::parameterization {

/// What it took to get a start without flips.
enum class StartMethod {
  uniform,   ///< Tutte's embedding as it is
  weighted,  ///< with weights that keep triangles from collapsing, or a flat chart as it lies
  untangled  ///< what was left was untangled
};

std::string_view start_method_name(StartMethod method) noexcept;

struct StartOptions {
  parameterization::TutteOptions tutte;
  bool keep_boundary = false;  ///< untangling leaves the boundary where Tutte's embedding has it
  UntangleOptions untangle;
  StopToken stop;  ///< asked now and then; a request to stop ends the work with what there is
};

struct StartResult {
  mesh::Points2 uv;  ///< #V x 2; empty when the linear solver failed
  StartMethod method = StartMethod::uniform;
  std::vector<int> flipped;  ///< triangles still collapsed or turned over; empty is success
  std::string message;       ///< of a failure, otherwise empty
  int reweightings = 0;
  UntangleResult untangling;
  bool ok() const { return uv.rows() > 0 && flipped.empty(); }
};

/// A flip-free layout of a chart, a disk or a disk with holes, to start a minimisation from: Tutte's
/// embedding with the holes closed for the time being, at the area that `rest` has (the chart's triangles,
/// see mesh::flat_elements). Where floating point collapses triangles their weights are raised, and what is
/// left of flips is untangled. Throws Error when the mesh is not such a chart.
StartResult flip_free_start(const mesh::SurfaceMesh& chart, const mesh::ElementArrays& rest,
                            const StartOptions& options = {});

}  // namespace isostretch::parameterization

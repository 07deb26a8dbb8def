#pragma once

#include <isostretch/parameterization/overlap_split.hpp>

#include <vector>

namespace isostretch::parameterization {

/// The result in output units.
struct Layout {
  mesh::Points2 uv;  ///< of the opened mesh
  bool packed = false;
  double scale = 1;          ///< uv lengths over lengths of the model, where nothing is distorted
  double coverage = 0;       ///< of the square, when packed: the share under triangles
  std::vector<int> flipped;  ///< triangles
  mesh::Overlap overlap;     ///< of the layout as it is written, charts on each other included
};

/// Packs the charts into a square where that is asked for, and brings uv to output units. Throws Error
/// (ExitCode::command_line) when the margin leaves no room.
Layout lay_out(const Domain& domain, const Start& start, const Solution& solution, const Options& options);

}  // namespace isostretch::parameterization

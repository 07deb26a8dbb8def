#pragma once

#include <isostretch/parameterization/overlap_split.hpp>

#include <vector>

namespace isostretch::parameterization {

/// A layout in output units.
struct Layout {
  mesh::Points2 uv;          ///< V x 2, of the opened mesh.
  bool packed = false;       ///< Whether charts are packed into the unit square.
  double scale = 1;          ///< Lengths of uv over lengths of the model, where nothing is distorted.
  double coverage = 0;       ///< Share of the square under triangles, when packed.
  std::vector<int> flipped;  ///< Triangles that are turned over.
  mesh::Overlap overlap;     ///< Overlap of the layout as it is written, charts on each other included.
};

/// Packs the charts into a square if the options say so, and brings uv to output units. Throws OptionError
/// when the margin leaves no room.
Layout lay_out(const Domain& domain, const Start& start, const Solution& solution, const Options& options);

}  // namespace isostretch::parameterization

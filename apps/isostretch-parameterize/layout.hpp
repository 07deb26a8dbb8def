#pragma once

#include "solve.hpp"

#include <vector>

namespace isostretch::app::parameterize {

// The result in output units.
struct Layout {
  mesh::Points2 uv;  // of the opened mesh
  bool packed = false;
  double scale = 1;          // uv lengths over lengths of the model, where nothing is distorted
  double coverage = 0;       // of the unit square, when packed
  std::vector<int> flipped;  // triangles
};

// Scales the charts to output units and, where that is asked for or there are several, packs them into the
// unit square. Throws Failure (ExitCode::command_line) when the margin leaves no room.
Layout lay_out(const Domain& domain, const Start& start, const Solution& solution, const Options& options);

}  // namespace isostretch::app::parameterize

#pragma once

#include "start.hpp"

#include <isostretch/newton/summary.hpp>

#include <vector>

namespace isostretch::app::parameterize {

struct Solution {
  newton::Summary summary;
  mesh::Points2 uv;  // in output units
  std::vector<double>
      stretches;               // singular values of every triangle's map, largest first; the last may be < 0
  double soft_pin_energy = 0;  // part of the energy
  std::vector<int> flipped;    // triangles of uv
  std::vector<int> pinned;     // vertices of the open mesh, hard and soft
};

// Minimises from the start; Ctrl-C ends it after the iteration. Throws Failure for pins that cannot be.
Solution solve(const Domain& domain, const Start& start, const energies::AnyEnergy& energy,
               const Options& options);

}  // namespace isostretch::app::parameterize

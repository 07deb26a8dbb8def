#pragma once

#include "domain.hpp"

#include <isostretch/energies/any_energy.hpp>
#include <isostretch/mesh/element_arrays.hpp>

namespace isostretch::app::parameterize {

// The solver's view: rest area 1, and a layout to start from.
struct Start {
  mesh::ElementArrays elements;
  double total_area = 0;   // of the input, in its units
  double unit_length = 1;  // output uv = unit_length * solver's uv
  mesh::Points2 uv;        // in the solver's units
  int flipped = 0;         // triangles of uv that are turned over
};

// Throws Failure with ExitCode::input when an element has no area, or when the start has flipped triangles
// that the energy cannot recover from; names them.
Start make_start(const Domain& domain, const energies::AnyEnergy& energy, const Options& options);

}  // namespace isostretch::app::parameterize

#pragma once

#include <isostretch/newton/summary.hpp>
#include <isostretch/parameterization/charts.hpp>
#include <isostretch/parameterization/pins.hpp>

#include <vector>

namespace isostretch::parameterization {

/// A minimisation of one chart.
struct Run {
  int chart = 0;
  bool first = true;  ///< of this chart and of what it was cut off from
  newton::Summary summary;
};

struct Solution {
  std::vector<Run> runs;          ///< in the order they were made; a chart that was cut further has several
  newton::Summary summary;        ///< of all together: sums of energies, counts and seconds, the worst status
  std::vector<int> chart_of_row;  ///< of its trace

  mesh::Points2 uv;  ///< in the solver's units, charts where they were solved
  std::vector<double>
      stretches;  ///< singular values of every triangle's map, largest first; the last may be < 0
  double soft_pin_energy = 0;   ///< part of the energy
  Pins pins;                    ///< vertices of the opened mesh
  int cuts = 0;                 ///< made for --max-distortion
  double worst_distortion = 1;  ///< largest of sigma_1 and 1 / sigma_2

  /// All lengths are next to none: the energy falls as triangles shrink, whatever their shape.
  bool has_vanished() const;
};

/// Minimises from the start, chart by chart; Ctrl-C ends it after the iteration. With a bound on the
/// distortion the domain is cut further until it is met or nothing more can be cut. Throws Error for pins
/// that cannot be.
Solution solve(Domain& domain, Start& start, const energies::AnyEnergy& energy, const Options& options,
               const Monitor& monitor = {});

}  // namespace isostretch::parameterization

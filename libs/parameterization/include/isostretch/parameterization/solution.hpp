#pragma once

#include <isostretch/newton/summary.hpp>
#include <isostretch/parameterization/charts.hpp>
#include <isostretch/parameterization/pins.hpp>

#include <vector>

namespace isostretch::parameterization {

/// A minimisation of one chart.
struct Run {
  int chart = 0;      ///< The chart.
  bool first = true;  ///< Whether it is the first of this chart and of the charts that it was cut off from.
  newton::Summary summary;  ///< The course and the end of the minimisation.
};

/// The minimised layout of all charts.
struct Solution {
  std::vector<Run> runs;  ///< In the order in which they were made; a chart that was cut further has several.
  newton::Summary summary;  ///< All runs together: sums of energies, counts and seconds, the worst status.
  std::vector<int> chart_of_row;  ///< Chart of every row of the summary's trace.

  mesh::Points2 uv;  ///< V x 2, in the solver's units, charts where they were solved.
  /// Singular values of every triangle's map, largest first; the last may be negative.
  std::vector<double> stretches;
  double soft_pin_energy = 0;   ///< Part of the energy that is that of soft pins.
  Pins pins;                    ///< Pins on vertices of the opened mesh.
  int cuts = 0;                 ///< Cuts that were made to meet a bound on the distortion.
  double worst_distortion = 1;  ///< The largest of sigma_1 and 1 / sigma_2 over all triangles.

  /// Returns whether all lengths are next to none: the energy falls as triangles shrink, whatever their
  /// shape.
  bool has_vanished() const;
};

/// Minimises the energy from the start, chart by chart; a request to stop ends it after the iteration. With a
/// bound on the distortion the domain is cut further until it is met or nothing more can be cut. Throws Error
/// for pins that cannot be held.
Solution solve(Domain& domain, Start& start, const energies::AnyEnergy& energy, const Options& options,
               const Monitor& monitor = {});

}  // namespace isostretch::parameterization

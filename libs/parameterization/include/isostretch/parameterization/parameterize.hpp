#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/core/phase_times.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/parameterization/layout.hpp>
#include <isostretch/parameterization/options.hpp>
#include <isostretch/parameterization/overlap_split.hpp>

namespace isostretch::parameterization {

/// A flattened surface, and the steps by which it was made.
struct Parameterization {
  Domain domain;       ///< The surface as it was cut.
  Start start;         ///< The charts, and the layout that the minimisation started from.
  Solution solution;   ///< The minimised layout, chart by chart.
  OverlapSplit split;  ///< The division of charts that lay on themselves.
  Layout layout;       ///< The result in output units.
  PhaseTimes times;    ///< Seconds of the phases domain, start, solve, overlap and layout.

  /// Returns whether the minimisation converged, no triangle is turned over, and max_distortion is met.
  bool succeeded(const Options& options) const;
  /// Returns the model with the layout as its texture coordinates: same vertices, same triangles.
  mesh::SurfaceMesh textured() const;
};

/// Flattens a surface: cuts it to disks where needed, starts without flips, minimises the energy chart by
/// chart, divides charts that lie on themselves, and packs them.
///
/// Takes an oriented manifold surface of triangles with areas; mesh::check() says what is wrong with others
/// and mesh::repair() mends what has one right answer. Notices of what was done go to the log. A request to
/// stop, or the limit of time, ends it with the best layout so far, which the status of `solution.summary`
/// says.
///
/// Throws OptionError for options that make no sense for this surface, Error naming the element for a surface
/// that cannot be flattened, and Error of the kinds stopped and unsolved when it ends before there is a
/// layout without flips.
Parameterization parameterize(const mesh::SurfaceMesh& model, const energies::AnyEnergy& energy,
                              const Options& options = {}, const Monitor& monitor = {});

}  // namespace isostretch::parameterization

#pragma once

#include <isostretch/assembly/elements.hpp>
#include <isostretch/newton/term.hpp>
#include <isostretch/parameterization/charts.hpp>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace isostretch::parameterization {

/// A node that is held at a place.
struct HardPin {
  int node = -1;                 ///< The node.
  std::optional<Point2> target;  ///< Place in the solver's units; none holds it where the start has it.
  std::optional<Eigen::RowVector2d> output;  ///< Place in output units, as it was asked for.
};

/// The pins of a layout. Nodes are vertices of the opened mesh, or of one chart of it.
struct Pins {
  std::vector<HardPin> hard;          ///< Nodes held at a place.
  std::vector<newton::SoftPin> soft;  ///< Nodes pulled towards a place.
  /// Returns the nodes of all hard pins.
  std::vector<int> nodes() const;
  /// Returns the pins of a chart, in its numbers.
  Pins of_chart(const Chart& chart) const;
};

/// Returns the pins of the options in the solver's numbers and units. Throws Error for vertices that do not
/// exist or are not one in the layout, for a vertex pinned both ways, and for charts that are going to be
/// packed.
Pins resolve_pins(const Domain& domain, const Start& start, const Options& options);

/// Moves the layout so that the hard pins with targets lie on them. A similarity comes first, which brings
/// two pins home exactly. Where more pins would turn triangles over and the energy has a barrier, the layout
/// is drawn towards the targets with soft pins until it can take them. Throws Error naming a triangle when it
/// never can.
void place_hard_pins(Vector& x, const Pins& pins, const assembly::Elements& elements,
                     const energies::AnyEnergy& energy, const Chart& chart, const Options& options);

}  // namespace isostretch::parameterization

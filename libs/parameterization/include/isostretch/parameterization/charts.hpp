#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/parameterization/domain.hpp>
#include <isostretch/parameterization/start.hpp>

#include <vector>

namespace isostretch::parameterization {

/// A connected piece of the opened mesh, which is solved by itself.
struct Chart {
  mesh::SurfaceMesh mesh;          ///< The triangles of the chart, with numbers of its own.
  std::vector<int> open_vertex;    ///< Vertex of the opened mesh of every vertex of the chart.
  std::vector<int> triangle;       ///< Triangle of the opened mesh of every triangle of the chart.
  mesh::ElementArrays rest;        ///< Rest shape, scaled so that the area of all charts together is 1.
  std::vector<int> held_boundary;  ///< Vertices of the chart that an option holds on the boundary.
  StartMethod method = StartMethod::uniform;  ///< How its start was made free of flips.
  int solved_as = -1;  ///< The chart that this was part of when it was solved, -1 for itself.

  /// Returns the rows of the chart's vertices in a layout of the opened mesh.
  mesh::Points2 gather(const mesh::Points2& uv) const;
  /// Writes the rows of the chart's vertices to a layout of the opened mesh.
  void scatter(const mesh::Points2& own, mesh::Points2& uv) const;
};

/// The charts at rest area 1, and a layout to start from.
struct Start {
  mesh::ElementArrays rest;   ///< Rest shape of the whole, triangle by triangle.
  double total_area = 0;      ///< Area of the input, in its units.
  double unit_length = 1;     ///< Length in output units of 1 in the solver's units.
  std::vector<Chart> charts;  ///< The charts.
  /// V x 2, layout of the opened mesh in the solver's units; charts lie on top of each other.
  mesh::Points2 uv;
  int flipped = 0;  ///< Triangles of the layout that are turned over.
};

/// Makes the charts and a layout to start from. Throws Error naming the triangles when one has no area, or
/// when the start has flipped ones that the energy cannot recover from, OptionError for corners and margins
/// that do not go with the charts, and Error of the kinds stopped and unsolved when there is no start.
Start make_start(const Domain& domain, const energies::AnyEnergy& energy, const Options& options,
                 const Monitor& monitor = {});

/// Returns the charts of the domain as it is cut now, without a start.
std::vector<Chart> make_charts(const Domain& domain, const Start& start);
/// Returns chart `number` of the domain as it is cut now, without a start.
Chart make_chart(const Domain& domain, const Start& start, int number);

}  // namespace isostretch::parameterization

#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/parameterization/domain.hpp>
#include <isostretch/parameterization/start.hpp>

#include <vector>

namespace isostretch::parameterization {

/// A connected piece of the opened mesh, solved by itself.
struct Chart {
  mesh::SurfaceMesh mesh;          ///< with numbers of its own
  std::vector<int> open_vertex;    ///< its vertices in the opened mesh
  std::vector<int> triangle;       ///< its triangles in the opened mesh
  mesh::ElementArrays rest;        ///< of all charts together the area is 1
  std::vector<int> held_boundary;  ///< vertices that --boundary holds, in the numbers of the chart
  StartMethod method = StartMethod::uniform;
  int solved_as = -1;  ///< the chart this was part of when it was solved; -1: itself

  /// Rows of a layout of the opened mesh, and back.
  mesh::Points2 gather(const mesh::Points2& uv) const;
  void scatter(const mesh::Points2& own, mesh::Points2& uv) const;
};

/// The solver's view: rest area 1, and a layout to start from.
struct Start {
  mesh::ElementArrays rest;  ///< of the whole, triangle by triangle
  double total_area = 0;     ///< of the input, in its units
  double unit_length = 1;    ///< output uv = unit_length * solver's uv
  std::vector<Chart> charts;
  mesh::Points2 uv;  ///< of the opened mesh, in the solver's units; charts lie on top of each other
  int flipped = 0;   ///< triangles of uv that are turned over
};

/// Makes the charts and a layout to start from. Throws Error naming the triangles when one has no area, or
/// when the start has flipped ones that the energy cannot recover from, OptionError for corners and margins
/// that do not go with the charts, and Error of the kinds stopped and unsolved when there is no start.
Start make_start(const Domain& domain, const energies::AnyEnergy& energy, const Options& options,
                 const Monitor& monitor = {});

/// The charts, or the chart of that number, of the domain as it is cut now, without a start.
std::vector<Chart> make_charts(const Domain& domain, const Start& start);
Chart make_chart(const Domain& domain, const Start& start, int number);

}  // namespace isostretch::parameterization

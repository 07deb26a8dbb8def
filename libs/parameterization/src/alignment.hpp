#pragma once

#include <isostretch/newton/objective.hpp>
#include <isostretch/parameterization/pins.hpp>

#include <vector>

namespace isostretch::parameterization {

// Vertices of a chart that lie on a line along the other axis: they share this coordinate.
struct Line {
  std::vector<int> nodes;
  int axis = 1;
};

// Those of the command line, with vertices of the opened mesh. Throws Error for
// vertices that do not exist or have several copies, and for a line through several charts.
std::vector<Line> resolve_lines(const Domain& domain, const Start& start, const Options& options);
// Those in a chart, in its numbers.
std::vector<Line> lines_of_chart(const std::vector<Line>& lines, const Chart& chart);

// Turns the layout (when nothing is pinned) and moves it until the vertices lie on their lines, to the bit.
// Throws Error when pins contradict a line or a triangle is in the way.
void place_lines(Vector& x, const std::vector<Line>& lines, const Pins& pins,
                 const assembly::Elements& elements, const energies::AnyEnergy& energy, const Chart& chart,
                 const Options& options);
void tie_lines(newton::Objective& objective, const std::vector<Line>& lines);

}  // namespace isostretch::parameterization

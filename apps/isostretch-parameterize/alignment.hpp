#pragma once

#include "pins.hpp"

#include <isostretch/newton/objective.hpp>

#include <vector>

namespace isostretch::app::parameterize {

// Vertices of a chart that lie on a line along the other axis: they share this coordinate.
struct Line {
  std::vector<int> nodes;
  int axis = 1;
};

// Those of the command line, with vertices of the opened mesh. Throws Failure (ExitCode::command_line) for
// vertices that do not exist or have several copies, and for a line through several charts.
std::vector<Line> resolve_lines(const Domain& domain, const Start& start, const Options& options);
// Those in a chart, in its numbers.
std::vector<Line> lines_of_chart(const std::vector<Line>& lines, const Chart& chart);

// Turns the layout (when nothing is pinned) and moves it until the vertices lie on their lines, to the bit.
// Throws Failure (ExitCode::input) when pins contradict a line or a triangle is in the way.
void place_lines(Vector& x, const std::vector<Line>& lines, const Pins& pins,
                 const assembly::Elements& elements, const energies::AnyEnergy& energy, const Chart& chart,
                 const Options& options);
void tie_lines(newton::Objective& objective, const std::vector<Line>& lines);

}  // namespace isostretch::app::parameterize

#pragma once

#include <isostretch/figures/layout_plot.hpp>
#include <isostretch/newton/summary.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// The contents of a figure of a parameterization.
struct SolveFigure {
  std::string title;                            ///< Title above the figure.
  std::string subtitle;                         ///< Line below the title.
  LayoutData layout;                            ///< The layout.
  const std::vector<double>& areas;             ///< Rest areas of the triangles.
  const std::vector<newton::Iteration>& trace;  ///< Iterations of the solve.
  const std::vector<int>& chart_of_row;         ///< Chart of every row of the trace.
};

/// Returns the layout on the left, the scale of distortion beside it, and the convergence on the right: the
/// bytes of a PNG of 1600 x 900 pixels.
std::string draw_solve(const SolveFigure& figure);

}  // namespace isostretch::figures

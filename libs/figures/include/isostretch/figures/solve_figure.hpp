#pragma once

#include <isostretch/figures/layout_plot.hpp>
#include <isostretch/newton/summary.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

struct SolveFigure {
  std::string title;
  std::string subtitle;
  LayoutData layout;
  const std::vector<double>& areas;  ///< rest areas of the triangles
  const std::vector<newton::Iteration>& trace;
  const std::vector<int>& chart_of_row;  ///< of the trace
};

/// Layout left, scale of distortion beside it, convergence right: a PNG of 1600 x 900 pixels, as bytes.
std::string draw_solve(const SolveFigure& figure);

}  // namespace isostretch::figures

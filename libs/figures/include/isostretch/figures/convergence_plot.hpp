#pragma once

#include <isostretch/figures/canvas.hpp>
#include <isostretch/newton/summary.hpp>

#include <vector>

namespace isostretch::figures {

/// Draws four small plots: energy above the best energy of the run, and |gradient|_inf, both logarithmic,
/// against iterations and against seconds. Charts are solved one after the other: the energy is that of all,
/// the gradient that of the chart of the row, with a curve of its own for each.
void draw_convergence(Canvas& canvas, const Box& box, const std::vector<newton::Iteration>& trace,
                      const std::vector<int>& chart_of_row);

}  // namespace isostretch::figures

#pragma once

#include "common/figures/canvas.hpp"

#include <isostretch/newton/summary.hpp>

#include <vector>

namespace isostretch::app::figures {

// Four small plots: energy above the best energy of the run, and |gradient|_inf, both logarithmic, against
// iterations and against seconds.
void draw_convergence(Canvas& canvas, const Box& box, const std::vector<newton::Iteration>& trace);

}  // namespace isostretch::app::figures

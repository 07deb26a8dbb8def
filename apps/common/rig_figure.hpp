#pragma once

#include <isostretch/figures/solid_figure.hpp>

namespace isostretch::app {

using figures::figure_lines;
using figures::rest_markers;
using figures::surface_points;
using figures::target_markers;

}  // namespace isostretch::app

#pragma once

#include <isostretch/figures/deformation_figure.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// Returns a colour for the handle of that number: seven that can be told apart, also by colour-blind eyes,
/// over and over.
Color handle_color(std::size_t handle);

/// What the legend says of one handle, in two lines beside a dot of its colour.
struct HandleLegend {
  std::string name;
  std::string facts;
};

struct HandleFigure {
  DeformationFigure body;  ///< with one state, whose triangle_colors and markers are drawn
  std::vector<HandleLegend> legend;
};

/// Draws the body with its handles beside the legend: a PNG 1600 pixels wide and, as the body needs, 480 to
/// 900 high, as bytes. Of more handles than fit into the legend, the last line says how many are not listed.
std::string draw_handles(const HandleFigure& figure);

}  // namespace isostretch::figures

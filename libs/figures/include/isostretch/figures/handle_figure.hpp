#pragma once

#include <isostretch/figures/deformation_figure.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// Returns the colour of a handle by its number: seven that can be told apart, also by colour-blind eyes,
/// over and over.
Color handle_color(std::size_t handle);

/// The two lines of the legend about one handle, beside a dot of its colour.
struct HandleLegend {
  std::string name;   ///< First line.
  std::string facts;  ///< Second line.
};

/// The contents of a figure of a body with its handles.
struct HandleFigure {
  DeformationFigure body;            ///< The body in one state, whose triangle_colors and markers are drawn.
  std::vector<HandleLegend> legend;  ///< An entry per handle.
};

/// Returns the body with its handles beside the legend: the bytes of a PNG 1600 pixels wide and, as the body
/// needs, 480 to 900 high. With more handles than fit into the legend, the last line says how many are not
/// listed.
std::string draw_handles(const HandleFigure& figure);

}  // namespace isostretch::figures

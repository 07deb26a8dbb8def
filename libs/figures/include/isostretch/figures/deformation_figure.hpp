#pragma once

#include <isostretch/figures/color_map.hpp>
#include <isostretch/figures/surface_model.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// What is drawn over a state: a dot, an arrow from one place to another, or a ring around where something is
/// to be, with a line to it from where it is.
struct Marker {
  enum class Kind { dot, arrow, target } kind = Kind::dot;
  Eigen::RowVector3d from, to;  ///< the same for a dot
  Color color{0.05, 0.2, 0.55};
  double radius = 5;           ///< of a dot, in pixels
  bool hollow_behind = false;  ///< a dot is a ring where the body lies in front of it
};

/// One state of the body in the figure, with the same triangles in all of them.
struct DeformedState {
  std::string caption;
  mesh::Points3 vertices;
  std::vector<double> length_change;  ///< of every element, see strain.hpp
  std::vector<int> inverted;          ///< elements
  std::vector<Marker> markers = {};
  std::vector<Color> triangle_colors = {};  ///< in place of those of the change of length
};

struct DeformationFigure {
  std::string title;
  std::string subtitle;
  std::vector<DeformedState> states;      ///< drawn side by side, equally large
  const mesh::Triangles& triangles;       ///< of the surface
  const std::vector<int>& element;        ///< behind every triangle
  std::vector<double> volumes;            ///< of the elements at rest
  std::vector<std::array<int, 2>> lines;  ///< to draw dark, as pairs of vertices: where handles end
  bool flat = false;                      ///< a body in the plane: seen from straight above
  int up = -1;                            ///< axis; -1: guessed
};

/// The states seen by one camera that fits the first, coloured by the largest change of length, averaged
/// around every vertex of the surface, with the scale and the histogram of the elements of the last state: a
/// PNG 1600 pixels wide and, as the body needs, 400 to 900 high, as bytes.
std::string draw_deformation(const DeformationFigure& figure);

/// Draws every state into a PNG of its own, 720 pixels wide, without titles: with one camera, one scale and
/// the colours of the last state's.
std::vector<std::string> draw_each(const DeformationFigure& figure);

}  // namespace isostretch::figures

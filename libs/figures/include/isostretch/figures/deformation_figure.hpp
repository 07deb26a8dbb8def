#pragma once

#include <isostretch/figures/color_map.hpp>
#include <isostretch/figures/surface_model.hpp>

#include <string>
#include <vector>

namespace isostretch::figures {

/// A mark drawn over a state: a dot, an arrow from one place to another, or a ring around a target with a
/// line to it from where the node is.
struct Marker {
  /// The look of a mark.
  enum class Kind { dot, arrow, target };

  Kind kind = Kind::dot;         ///< Look.
  Eigen::RowVector3d from;       ///< Beginning of an arrow, and where a node is.
  Eigen::RowVector3d to;         ///< End of an arrow, and target; the same as `from` for a dot.
  Color color{0.05, 0.2, 0.55};  ///< Colour.
  double radius = 5;             ///< Radius of a dot, in pixels.
  bool hollow_behind = false;    ///< Whether a dot is a ring where the body lies in front of it.
};

/// A state of the body in the figure; all states have the same triangles.
struct DeformedState {
  std::string caption;     ///< Text below the state.
  mesh::Points3 vertices;  ///< V x 3, positions.
  /// Largest factor by which a length changes, of every element; see deformation::StrainField.
  std::vector<double> length_change;
  std::vector<int> inverted;         ///< Elements with det F <= 0.
  std::vector<Marker> markers = {};  ///< Marks over the body.
  /// Colours of triangles, in place of those of the change of length.
  std::vector<Color> triangle_colors = {};
};

/// The contents of a figure of deformed states.
struct DeformationFigure {
  std::string title;                      ///< Title above the figure.
  std::string subtitle;                   ///< Line below the title.
  std::vector<DeformedState> states;      ///< States, drawn side by side, equally large.
  const mesh::Triangles& triangles;       ///< Triangles of the surface.
  const std::vector<int>& element;        ///< Element behind every triangle.
  std::vector<double> volumes;            ///< Volumes of the elements at rest.
  std::vector<std::array<int, 2>> lines;  ///< Lines to draw dark, as pairs of vertices: where handles end.
  bool flat = false;                      ///< Whether the body is in the plane, and seen from straight above.
  int up = -1;                            ///< Axis that points up; -1 guesses it.
};

/// Returns the states seen by one camera that fits the first, coloured by the largest change of length,
/// averaged around every vertex of the surface, with the scale and the histogram of the elements of the last
/// state: the bytes of a PNG 1600 pixels wide and, as the body needs, 400 to 900 high.
std::string draw_deformation(const DeformationFigure& figure);

/// Returns a PNG of every state, 720 pixels wide, without titles: with one camera, one scale and the colours
/// of the last state's.
std::vector<std::string> draw_each(const DeformationFigure& figure);

}  // namespace isostretch::figures

#pragma once

#include <isostretch/parameterization/parameterize.hpp>

#include <string>

namespace isostretch::figures {

/// A flattened surface and what its pictures say of it.
struct ParameterizationFigure {
  const parameterization::Parameterization& result;  ///< The surface and its layout.
  std::string title;                                 ///< Text at the top.
  bool unit_square = false;  ///< Whether the layout is shown inside the unit square, to which it belongs.
};

/// Returns the layout, coloured by distortion, with the convergence of the solve beside it, as bytes of a
/// PNG.
std::string draw_layout(const ParameterizationFigure& figure);

/// Returns the model in space with the layout on it as a checkerboard, as bytes of a PNG. Dark lines are
/// seams and boundaries.
std::string draw_model(const ParameterizationFigure& figure);

/// Returns the side, in uv, of the squares of the checkerboard in pictures and texture: as many fit over the
/// whole layout as over a square of 30 by 30, in charts that are packed and in those that are not.
double checker_square(const parameterization::Parameterization& result);

/// Returns the model as binary glTF with a checkerboard in it, whose squares are those of draw_model(). Its
/// uv are those of the layout; how often the texture repeats is said by the material. Throws Error for
/// coordinates that do not fit into floats.
std::string textured_glb(const parameterization::Parameterization& result);

/// Returns a share in percent: two digits that count, and zero for zero alone.
std::string share_text(double share);

}  // namespace isostretch::figures

#pragma once

#include <isostretch/figures/surface_model.hpp>

#include <string>

namespace isostretch::figures {

/// The contents of a figure of a model.
struct ModelFigure {
  std::string title;     ///< Title above the figure.
  std::string subtitle;  ///< Line below the title.
  ModelData model;       ///< The model, with its vertices anywhere.
};

/// Returns the model from the front and from behind, side by side and equally large, chosen by guess_pose():
/// the bytes of a PNG 1600 pixels wide and, as the model needs, 400 to 900 high.
std::string draw_model(const ModelFigure& figure);

}  // namespace isostretch::figures

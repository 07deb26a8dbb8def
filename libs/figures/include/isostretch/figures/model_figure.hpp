#pragma once

#include <isostretch/figures/surface_model.hpp>

#include <string>

namespace isostretch::figures {

struct ModelFigure {
  std::string title;
  std::string subtitle;
  ModelData model;  ///< vertices anywhere
};

/// The model from the front and from behind, side by side and equally large, chosen by guess_pose(): a PNG
/// 1600 pixels wide and, as the model needs, 400 to 900 high, as bytes.
std::string draw_model(const ModelFigure& figure);

}  // namespace isostretch::figures

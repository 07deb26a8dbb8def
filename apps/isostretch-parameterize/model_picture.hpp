#pragma once

#include "report.hpp"

#include <string>

namespace isostretch::app::parameterize {

// model.png: the model in space with the layout on it as a checkerboard.
std::string draw_model(const Result& result);

}  // namespace isostretch::app::parameterize

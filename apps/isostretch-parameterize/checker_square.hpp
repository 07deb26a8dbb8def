#pragma once

#include "report.hpp"

namespace isostretch::app::parameterize {

// Side, in uv, of the squares of the checkerboard in pictures and texture: as many fit over the whole layout
// as over a square of 30 by 30, in charts that are packed and in those that are not.
double checker_square(const Result& result);

}  // namespace isostretch::app::parameterize

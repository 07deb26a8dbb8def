#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::parameterization {

// The direction (a unit vector) of the longer side of the smallest rectangle around the points; of the x axis
// when they are all the same.
struct Direction {
  double x = 1, y = 0;
};
Direction smallest_rectangle(const mesh::Points2& points);

}  // namespace isostretch::parameterization

#pragma once

#include <vector>

namespace isostretch::parameterization {

struct Rectangle {
  double width = 0, height = 0;
  double x = 0, y = 0;  // lower left corner, once placed
};

// Places rectangles into a strip of that width, each as low as it goes, then as far left (bottom-left
// skyline), the highest first; returns the height that they take. A rectangle wider than the strip sticks
// out: make the strip as wide as the widest.
double place_on_skyline(std::vector<Rectangle>& rectangles, double strip_width);

// The same with the width for which the square around them all is smallest, of a few dozen tried; returns its
// side.
double place_in_square(std::vector<Rectangle>& rectangles);

}  // namespace isostretch::parameterization

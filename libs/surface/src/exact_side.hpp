#pragma once

#include <array>

namespace isostretch::mesh {

using PlanePoint = std::array<double, 2>;

// On which side of the line from a to b the point c lies: 1 left, -1 right, 0 on it; exact. Products of
// coordinates must neither overflow nor come below 1e-290 unless they are zero.
int side(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

// Twice the signed area of the triangle a, b, c: with the sign of side(), and to 15 digits or so whatever
// cancels.
double doubled_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

}  // namespace isostretch::mesh

#pragma once

#include <array>
#include <vector>

namespace isostretch::mesh {

// Cuts a polygon in space into triangles along its diagonals, in the plane that fits it; concave ones too.
// The result has three corners a triangle, from 0, in the order of the polygon. Of the two diagonals of a
// quad, and of all ears of a polygon, the one that leaves the best triangles is taken. Empty where no cut
// leaves triangles of positive area: the polygon crosses itself or is a line.
std::vector<int> triangulated(const std::vector<std::array<double, 3>>& polygon);

}  // namespace isostretch::mesh

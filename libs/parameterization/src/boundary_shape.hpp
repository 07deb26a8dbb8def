#pragma once

#include <isostretch/parameterization/tutte.hpp>

#include <vector>

namespace isostretch::parameterization {

// Places a boundary loop counter-clockwise on the circle (the polygon inscribed has area 1) or unit square
// around the origin. Throws Error for corners that are not four different vertices of the loop in order.
void place_boundary(const mesh::Points3& vertices, const std::vector<int>& loop, const TutteOptions& options,
                    mesh::Points2& uv);

}  // namespace isostretch::parameterization

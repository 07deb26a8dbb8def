#pragma once

#include <isostretch/mesh/tutte.hpp>

#include <vector>

namespace isostretch::mesh {

// Places a boundary loop counter-clockwise on the circle (the polygon inscribed has area 1) or unit square
// around the origin. Throws Error for corners that are not four different vertices of the loop in order.
void place_boundary(const Points3& vertices, const std::vector<int>& loop, const TutteOptions& options,
                    Points2& uv);

}  // namespace isostretch::mesh

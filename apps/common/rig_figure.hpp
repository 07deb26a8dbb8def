#pragma once

#include "common/rig.hpp"

#include <array>
#include <vector>

namespace isostretch::app {

// What figures of a body with handles have in common.

// The vertices of the body's surface where its nodes are at `points`.
mesh::Points3 surface_points(const Body& body, const mesh::Points3& points);

// Lines to draw dark, between vertices of the surface: where handles end, and the outline of a body in the
// plane.
std::vector<std::array<int, 2>> figure_lines(const Rig& rig, const Body& body);

}  // namespace isostretch::app

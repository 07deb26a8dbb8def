#pragma once

#include "common/deformation_names.hpp"

#include <isostretch/figures/deformation_figure.hpp>

#include <array>
#include <vector>

namespace isostretch::app {

// What figures of a body with handles have in common.

// The vertices of the body's surface where its nodes are at `points`.
mesh::Points3 surface_points(const SolidModel& body, const mesh::Points3& points);

// Lines to draw dark, between vertices of the surface: where handles end, and the outline of a body in the
// plane.
std::vector<std::array<int, 2>> figure_lines(const HandleSet& handle_set, const SolidModel& body);

/// Dots at handles of one vertex, and an arrow for every handle that moves, from where it is at rest to where
/// it is to be.
std::vector<figures::Marker> rest_markers(const HandleSet& handle_set, const SolidModel& body, double time);

/// Dots at handles of one vertex, and rings where soft handles are to be at that time: of each handle sixty
/// vertices of the surface at most, spread evenly over its vertices.
std::vector<figures::Marker> target_markers(const HandleSet& handle_set, const SolidModel& body, double time,
                                            const Vector& positions);

}  // namespace isostretch::app

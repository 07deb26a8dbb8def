#pragma once

#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/figures/deformation_figure.hpp>

#include <array>
#include <vector>

namespace isostretch::figures {

/// Returns the vertices of the body's surface where its nodes are at `points`.
mesh::Points3 surface_points(const deformation::SolidModel& body, const mesh::Points3& points);

/// Returns the outline of a body in the plane, as pairs of vertices of its surface; none in space.
std::vector<std::array<int, 2>> outline(const deformation::SolidModel& body);

/// Returns lines to draw dark, as pairs of vertices of the surface: where handles end, and the outline of a
/// body in the plane.
std::vector<std::array<int, 2>> figure_lines(const deformation::HandleSet& handle_set,
                                             const deformation::SolidModel& body);

/// Returns dots at handles of one vertex, and an arrow for every handle that moves, from where it is at rest
/// to where it is to be.
std::vector<Marker> rest_markers(const deformation::HandleSet& handle_set,
                                 const deformation::SolidModel& body, double time);

/// Returns dots at handles of one vertex, and rings where soft handles are to be at that time: of each handle
/// 120 vertices of the surface at most, spread evenly over its vertices.
std::vector<Marker> target_markers(const deformation::HandleSet& handle_set,
                                   const deformation::SolidModel& body, double time, const Vector& positions);

}  // namespace isostretch::figures

#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

// Divides the triangles of a layout into connected parts none of which overlaps itself. `group` says which
// triangles belong together to begin with; triangles of different groups may lie on each other. Parts are
// counted from 0 in the order of their first triangles.
std::vector<int> parts_without_overlap(const SurfaceMesh& mesh, const std::vector<int>& group,
                                       const Points2& uv);

}  // namespace isostretch::mesh

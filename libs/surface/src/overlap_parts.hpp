#pragma once

#include <isostretch/mesh/types.hpp>
#include <isostretch/surface/cut.hpp>

#include <vector>

namespace isostretch::mesh {

// For every triangle those of its chart that it overlaps.
using Partners = std::vector<std::vector<int>>;
Partners overlap_partners(const Cut& cut, const Points2& uv);

// Divides the charts of a layout into connected parts none of which overlaps itself; triangles of different
// charts may lie on each other. Returns a part for every triangle, counted from 0 in the order of their first
// triangles. Parts are separated along the shortest ways, where one that leaves a spur of the cut counts as
// so many times longer at its end.
std::vector<int> parts_without_overlap(const Cut& cut, const Points2& uv, const Partners& partners,
                                       int spur_detour);

}  // namespace isostretch::mesh

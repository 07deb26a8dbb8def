#pragma once

#include <isostretch/mesh/types.hpp>

#include <array>
#include <vector>

namespace isostretch::mesh {

/// The part of a layout that lies on itself, as find_overlap() measures it.
struct Overlap {
  double covered_area = 0;     ///< Area of the plane under at least one triangle, that of the union.
  double overlapped_area = 0;  ///< Area of the plane under more than one triangle.
  std::vector<int> triangles;  ///< Triangles whose interiors meet that of another, ascending.

  /// Returns the share of the covered area that lies under more than one triangle, from 0 to 1.
  double share() const { return covered_area > 0 ? overlapped_area / covered_area : 0; }
};

/// Returns the triangles of a planar layout that lie on others, and the area of the overlap.
///
/// Two triangles overlap where their interiors meet, which is decided exactly for the coordinates given.
/// Triangles that lie beside each other along an edge or at a vertex do not; a triangle that is folded or
/// turned over onto its neighbour does; a triangle without area overlaps nothing. Orientation has no say in
/// areas. Areas carry rounding errors only. For n triangles it takes n log n operations, and more where many
/// cross in one place; those that many others hide cost little. Results are the same for any number of
/// threads.
///
/// Throws Error when an index is out of range or a coordinate is not finite.
Overlap find_overlap(const Points2& uv, const Triangles& triangles);

/// Returns the pairs of triangles whose interiors meet, the smaller number first, ascending; decided exactly,
/// as in find_overlap(). Takes memory for every pair: n^2 / 2 pairs of n equal triangles. Throws Error when
/// an index is out of range or a coordinate is not finite.
std::vector<std::array<int, 2>> overlapping_pairs(const Points2& uv, const Triangles& triangles);

/// Moves boundary vertices of triangles that overlap inward by a distance, in the units of uv, and returns
/// how many. Both sides of a cut that stays closed lie on each other but for what a solver leaves, and
/// overlap by as little: a distance far below a texture's pixel parts them. Triangles are counter-clockwise
/// seen from the left of their boundary; ends of cuts stay, and so does whatever would turn a triangle over.
/// Throws Error when an index is out of range or a coordinate is not finite.
int part_sides(Points2& uv, const Triangles& triangles, double distance);

}  // namespace isostretch::mesh

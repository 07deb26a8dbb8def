#pragma once

#include "elements.hpp"
#include "place.hpp"

#include <cstdint>
#include <vector>

namespace isostretch::mesh {

inline constexpr int vtk_triangle = 5;
inline constexpr int vtk_triangle_strip = 6;
inline constexpr int vtk_polygon = 7;
inline constexpr int vtk_quad = 9;
inline constexpr int vtk_tet = 10;
inline constexpr int vtk_hex = 12;
inline constexpr int vtk_quadratic_triangle = 22;
inline constexpr int vtk_quadratic_tet = 24;

// Cell c has the points connectivity[offsets[c]] to connectivity[offsets[c + 1] - 1]; offsets begin with 0.
struct VtkCells {
  std::vector<std::int64_t> offsets;
  std::vector<std::int64_t> connectivity;

  std::size_t count() const { return offsets.empty() ? 0 : offsets.size() - 1; }
};

// Checks that offsets rise and end with the connectivity.
void require_offsets(const VtkCells& cells, const Place& place);

// Adds those that the list wants to it. Type of cell c is types[c]; `first_point` is added to every index,
// which is from 0 to point_count - 1. Failures are at `place` and name the cell.
void add_cells(const VtkCells& cells, const std::vector<std::int64_t>& types, int first_point,
               std::size_t point_count, const Place& place, ElementList& elements);

}  // namespace isostretch::mesh

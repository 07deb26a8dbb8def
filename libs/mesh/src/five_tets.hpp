#pragma once

#include <isostretch/mesh/types.hpp>

#include <array>
#include <utility>
#include <vector>

namespace isostretch::mesh {

// A corner of a cell of a box of cells, or a cell by its lowest corner.
struct Place {
  int i = 0, j = 0, k = 0;
};

// The cell cut into five: one tetrahedron at each of the four corners whose coordinates have an even sum, one
// between these. Cells that share a face cut it alike.
template <class Number>
inline void append_five(std::vector<std::array<int, 4>>& tets, const Place& cell, const Number& number) {
  const bool odd = (cell.i + cell.j + cell.k) % 2 != 0;
  const auto corner = [&](int x, int y, int z) {
    return number(Place{cell.i + (odd ? 1 - x : x), cell.j + y, cell.k + z});
  };
  const auto append = [&](int a, int b, int c, int d) {
    if (odd) std::swap(c, d);  // the mirror image turned every tetrahedron over
    tets.push_back({a, b, c, d});
  };
  const int a = corner(1, 0, 0), b = corner(0, 1, 0), c = corner(0, 0, 1), d = corner(1, 1, 1);
  append(corner(0, 0, 0), a, b, c);
  append(corner(1, 1, 0), b, a, d);
  append(corner(1, 0, 1), a, c, d);
  append(corner(0, 1, 1), c, b, d);
  append(a, b, c, d);
}

inline Tets rows_of(const std::vector<std::array<int, 4>>& tets) {
  Tets rows(static_cast<Eigen::Index>(tets.size()), 4);
  for (std::size_t t = 0; t < tets.size(); ++t)
    rows.row(static_cast<Eigen::Index>(t)) << tets[t][0], tets[t][1], tets[t][2], tets[t][3];
  return rows;
}

}  // namespace isostretch::mesh

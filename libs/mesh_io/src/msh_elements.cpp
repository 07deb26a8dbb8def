#include "msh_elements.hpp"

#include <array>

namespace isostretch::mesh {

CellKind msh_kind(std::int64_t type) {
  using enum Family;
  // Types 0 to 31.
  constexpr std::array<CellKind, 32> kinds = {
      {{point, 0},     {line, 2},      {triangle, 3}, {quad, 4},      {tet, 4},       {hex, 8},
       {prism, 6},     {pyramid, 5},   {line, 3},     {triangle, 6},  {quad, 9},      {tet, 10},
       {hex, 27},      {prism, 18},    {pyramid, 14}, {point, 1},     {quad, 8},      {hex, 20},
       {prism, 15},    {pyramid, 13},  {triangle, 9}, {triangle, 10}, {triangle, 12}, {triangle, 15},
       {triangle, 15}, {triangle, 21}, {line, 4},     {line, 5},      {line, 6},      {tet, 20},
       {tet, 35},      {tet, 56}}};
  if (type == 92) return {hex, 64};
  if (type == 93) return {hex, 125};
  return type > 0 && type < static_cast<std::int64_t>(kinds.size()) ? kinds[static_cast<std::size_t>(type)]
                                                                    : kinds[0];
}

}  // namespace isostretch::mesh

#include "msh_elements.hpp"

#include <array>

namespace isostretch::mesh {

Shape msh_shape(std::int64_t type) {
  constexpr int quadrangle = 3;
  if (type == msh_triangle || type == quadrangle) return Shape::face;
  return type == msh_tet ? Shape::tet : Shape::other;
}

int msh_node_count(std::int64_t type) {
  // Types 1 to 31: points, lines, triangles, quadrangles, tetrahedra, hexahedra, prisms, pyramids of several
  // orders; 92 and 93 are hexahedra of orders 3 and 4.
  constexpr std::array<int, 32> counts = {0, 2,  3,  4,  4, 8,  6,  5,  3,  6,  9, 10, 27, 18, 14, 1,
                                          8, 20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5,  6,  20, 35, 56};
  if (type == 92) return 64;
  if (type == 93) return 125;
  return type > 0 && type < static_cast<std::int64_t>(counts.size()) ? counts[static_cast<std::size_t>(type)]
                                                                     : 0;
}

}  // namespace isostretch::mesh

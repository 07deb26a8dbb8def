// A bar of tetrahedra, and vertices at one place made one.
#include "expect.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/weld.hpp>

int main() {
  using namespace isostretch;
  const auto bar = mesh::tet_bar(4, 2, 2, 2.0);
  EXPECT(bar.tets.rows() == 4 * 2 * 2 * 6);

  auto square = mesh::grid(1, 1);
  square.vertices.row(3) = square.vertices.row(2);
  EXPECT(mesh::weld(square) == 1);

  // Memory made there is resized and freed here.
  square.vertices.resize(1, 3);
}

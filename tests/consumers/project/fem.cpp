// Rest gradients of a bar of tetrahedra: the volume is that of the bar.
#include "expect.hpp"

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>

#include <cmath>

int main() {
  using namespace isostretch;
  const auto elements = mesh::elements(mesh::tet_bar(4, 2, 2, 2.0));
  EXPECT(std::abs(mesh::total_weight(elements) - 2.0) < 1e-14);
}

// A sphere written and read back, bit for bit.
#include "expect.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

int main() {
  using namespace isostretch;
  auto sphere = mesh::icosphere(2);
  const auto again = mesh::parse_obj(mesh::format_obj(sphere), "memory");
  EXPECT(again.vertices == sphere.vertices && again.triangles == sphere.triangles);
}

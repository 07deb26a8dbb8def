// A sphere opened by one cut.
#include "expect.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/cut.hpp>

int main() {
  using namespace isostretch;
  auto disk = mesh::cut_to_disks(mesh::icosphere(2)).mesh;
  mesh::require_disk(disk);

  // Memory made there is resized and freed here.
  disk.uv.conservativeResize(2, 2);
}

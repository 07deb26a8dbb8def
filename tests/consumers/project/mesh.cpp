// A sphere opened by one cut, embedded without flips, written and read back.
#include "expect.hpp"

#include <isostretch/mesh/cut.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/io.hpp>
#include <isostretch/mesh/orientation.hpp>
#include <isostretch/mesh/tutte.hpp>

int main() {
  auto disk = isostretch::mesh::cut_to_disks(isostretch::mesh::icosphere(2)).mesh;
  const auto tutte = isostretch::mesh::tutte_embedding(disk);
  EXPECT(tutte.status == isostretch::mesh::TutteStatus::ok);
  EXPECT(isostretch::mesh::count_flipped(tutte.uv, disk.triangles) == 0);

  disk.uv = tutte.uv;
  disk.uv_triangles = disk.triangles;
  const auto again = isostretch::mesh::parse_obj(isostretch::mesh::format_obj(disk), "memory");
  EXPECT(again.uv == disk.uv && again.vertices == disk.vertices && again.triangles == disk.triangles);

  // Memory made there is resized and freed here.
  disk.vertices.resize(1, 3);
  disk.uv.conservativeResize(2, 2);
}

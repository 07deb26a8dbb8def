// Files of other programs, where they are at hand.
#include "formats.hpp"

#include <isostretch/surface/check.hpp>

#include <doctest/doctest.h>

#include <filesystem>

using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
namespace fs = std::filesystem;

namespace {

const fs::path folder = fs::path(ISOSTRETCH_SOURCE_DIR) / ".." / "shared" / "meshes";

bool there(const std::string& name) {
  if (fs::exists(folder / name)) return true;
  MESSAGE("skipped, not there: ", name);
  return false;
}

}  // namespace

TEST_CASE("files of other programs: surfaces") {
  struct Known {
    const char* name;
    int vertices, triangles;
  };
  for (const Known& known :
       {Known{"surfaces/cow.obj", 2903, 5804}, Known{"surfaces/decimated-max.obj", 5272, 10540},
        Known{"surfaces/spot.obj", 2930, 5856}, Known{"surfaces/fertility.off", 4494, 9000}}) {
    if (!there(known.name)) continue;
    CAPTURE(std::string(known.name));
    const SurfaceMesh mesh = read_surface((folder / known.name).string());
    CHECK(mesh.vertices.rows() == known.vertices);
    CHECK(mesh.triangles.rows() == known.triangles);
    CHECK(check(mesh).indices_valid);
  }
}

TEST_CASE("files of other programs: tetrahedra, and the same bits through every format") {
  struct Known {
    const char* name;
    int vertices, tets, triangles;
  };
  for (const Known& known :
       {Known{"tets/bob.mesh", 4879, 17894, 6806}, Known{"tets/cube.mesh", 3306, 16385, 2090},
        Known{"tets/cylinder_20.mesh", 6103, 29104, 5488}, Known{"tets/hand.mesh", 7234, 29998, 9556},
        Known{"tets/octopus-low.mesh", 452, 1140, 898}, Known{"tets/bunny5K.msh", 4670, 19379, 0},
        Known{"tets/horse7K.msh", 7476, 31092, 0}}) {
    if (!there(known.name)) continue;
    CAPTURE(std::string(known.name));
    const TetMesh mesh = read_tets((folder / known.name).string());
    CHECK(mesh.vertices.rows() == known.vertices);
    CHECK(mesh.tets.rows() == known.tets);
    CHECK(check(mesh).indices_valid);
    if (known.triangles > 0)
      CHECK(read_surface((folder / known.name).string()).triangles.rows() == known.triangles);
    for (const auto& [name, contents] :
         {std::pair{"m.msh", format_msh(mesh)}, std::pair{"m.mesh", format_medit(mesh)},
          std::pair{"m.vtk", format_vtk(mesh)}, std::pair{"m.vtu", format_vtu(mesh)}}) {
      const TetMesh back = parse_tets(name, contents);
      CHECK(back.vertices == mesh.vertices);
      CHECK(back.tets == mesh.tets);
    }
  }
}

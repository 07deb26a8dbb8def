// Files of other programs, where they are at hand.
#include "conditional.hpp"
#include "formats.hpp"

#include <isostretch/surface/check.hpp>

#include <doctest/doctest.h>

using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

TEST_CASE("files of other programs: surfaces" * outside_data({"meshes/surfaces"})) {
  struct Known {
    const char* name;
    int vertices, triangles;
  };
  for (const Known& known :
       {Known{"meshes/surfaces/cow.obj", 2903, 5804}, Known{"meshes/surfaces/decimated-max.obj", 5272, 10540},
        Known{"meshes/surfaces/spot.obj", 2930, 5856}, Known{"meshes/surfaces/fertility.off", 4494, 9000}}) {
    CAPTURE(std::string(known.name));
    const SurfaceMesh mesh = read_surface(outside_path(known.name));
    CHECK(mesh.vertices.rows() == known.vertices);
    CHECK(mesh.triangles.rows() == known.triangles);
    CHECK(check(mesh).indices_valid);
  }
}

TEST_CASE("files of other programs: tetrahedra, and the same bits through every format" *
          outside_data({"meshes/tets"})) {
  struct Known {
    const char* name;
    int vertices, tets, triangles;
  };
  for (const Known& known :
       {Known{"meshes/tets/bob.mesh", 4879, 17894, 6806}, Known{"meshes/tets/cube.mesh", 3306, 16385, 2090},
        Known{"meshes/tets/cylinder_20.mesh", 6103, 29104, 5488},
        Known{"meshes/tets/hand.mesh", 7234, 29998, 9556},
        Known{"meshes/tets/octopus-low.mesh", 452, 1140, 898},
        Known{"meshes/tets/bunny5K.msh", 4670, 19379, 0}, Known{"meshes/tets/horse7K.msh", 7476, 31092, 0}}) {
    CAPTURE(std::string(known.name));
    const TetMesh mesh = read_tets(outside_path(known.name));
    CHECK(mesh.vertices.rows() == known.vertices);
    CHECK(mesh.tets.rows() == known.tets);
    CHECK(check(mesh).indices_valid);
    if (known.triangles > 0)
      CHECK(read_surface(outside_path(known.name)).triangles.rows() == known.triangles);
    for (const auto& [name, contents] :
         {std::pair{"m.msh", format_msh(mesh)}, std::pair{"m.mesh", format_medit(mesh)},
          std::pair{"m.vtk", format_vtk(mesh)}, std::pair{"m.vtu", format_vtu(mesh)}}) {
      const TetMesh back = parse_tets(name, contents);
      CHECK(back.vertices == mesh.vertices);
      CHECK(back.tets == mesh.tets);
    }
  }
}

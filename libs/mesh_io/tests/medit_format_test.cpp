#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

const std::string head =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";

void refused(const std::string& contents, const char* message) {
  CAPTURE(contents);
  CHECK_THROWS_WITH_AS(parse_medit_surface(contents, "m.mesh"), message, Error);
}

}  // namespace

TEST_CASE("MEDIT: two dimensions give z = 0") {
  const SurfaceMesh mesh = parse_medit_surface(
      "MeshVersionFormatted 1\n\nDimension 2\nVertices 3\n0 0 1\n1 0 1\n0.5 1 1\nEdges 1 1 2 1\nTriangles "
      "1\n1 2 3 1\nEnd\n",
      "m.mesh");
  CHECK(mesh.vertices == rows<Points3>({0, 0, 0, 1, 0, 0, 0.5, 1, 0}));
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 2}));
}

TEST_CASE("MEDIT: other sections, any case, elements before vertices, no end") {
  const std::string text =
      "meshversionformatted 2 # comment\nDIMENSION 3\nTetrahedra 1 1 2 3 4 0\nRidges\n1\n1\nTriangles\n1\n1 "
      "2 3 5\n"
      "Normals 1 0 0 1\nVertices 4 0 0 0 0.5 1 0 0 0 0 1 0 0 0 0 1 0\nHexahedra\n0\nSomethingNew\n3 4 -5e3\n";
  CHECK(parse_medit_surface(text, "m.mesh").triangles == rows<Triangles>({0, 1, 2}));
  CHECK(parse_medit_tets(text, "m.mesh").tets == rows<Tets>({0, 1, 2, 3}));
  CHECK(parse_medit_tets(text, "m.mesh").vertices.row(3) == Eigen::RowVector3d(0, 0, 1));
}

TEST_CASE("MEDIT: quadrilaterals are polygons") {
  const std::string text = head + "Quadrilaterals\n1\n1 2 3 4 0\nEnd\n";
  CHECK(parse_medit_surface(text, "m.mesh").triangles.rows() == 2);
}

TEST_CASE("MEDIT: faults are named by line") {
  refused("", "m.mesh:1: not a MEDIT file: it does not begin with MeshVersionFormatted");
  refused("MeshVersionFormatted\n", "m.mesh:1: missing version");
  refused("MeshVersionFormatted 2\nDimension 4\n", "m.mesh:2: dimension 4 is neither 2 nor 3");
  refused("MeshVersionFormatted 2\nVertices\n1\n", "m.mesh:2: Vertices before Dimension");
  refused("MeshVersionFormatted 2\nDimension 3\n17\n", "m.mesh:3: keyword expected, not '17'");
  refused(head + "Vertices\n0\n", "m.mesh:9: Vertices for the second time");
  refused("MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n",
          "m.mesh:4: number of vertices 4 is more than the file can hold");
  refused("MeshVersionFormatted 2\nDimension 3\nVertices\n-4\n",
          "m.mesh:4: number of vertices is negative: -4");
  refused("MeshVersionFormatted 2\nDimension 3\nVertices\n1\n0 0 nan 0\n",
          "m.mesh:5: z coordinate 'nan' is not finite");
  refused("MeshVersionFormatted 2\nDimension 3\nVertices\n1\n0 0 End 0\n",
          "m.mesh:5: z coordinate 'End' is not a number");
  refused(head, "m.mesh:8: no triangles");
  refused(head + "End\n", "m.mesh:9: no triangles");
  refused(head + "Triangles\n0\nEnd\n", "m.mesh:11: no triangles");
  refused(head + "Tetrahedra\n1\n1 2 3 4 0\nEnd\n",
          "m.mesh:12: no triangles: a mesh of 1 tetrahedron, to be read as such");
  refused(head + "Triangles\n1\n1 2 5 0\nEnd\n", "m.mesh:11: vertex index 5 is out of range: there are 4");
  refused(head + "Triangles\n1\n1 2 0 0\nEnd\n", "m.mesh:11: vertex index 0 is out of range: there are 4");
  refused(head + "Triangles\n1\n1 2 -3 0\nEnd\n", "m.mesh:11: vertex index -3 is out of range: there are 4");
  refused(head + "Triangles\n2\n1 2 3 0\nEnd\n",
          "m.mesh:10: number of elements 2 is more than the file can hold");
}

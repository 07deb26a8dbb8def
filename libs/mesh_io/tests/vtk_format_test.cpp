#include "contents.hpp"
#include "meshes.hpp"
#include "vtk_samples.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

const std::string head = vtk_header(false);
const std::string points = "POINTS 4 float\n0 0 0 1 0 0\n1 1 0 0 1 0\n";

void refused(const std::string& contents, const char* message) {
  CAPTURE(contents);
  CHECK_THROWS_WITH_AS(parse_vtk_surface(contents, "m.vtk"), message, Error);
}

}  // namespace

TEST_CASE("VTK: strips, polygons, lines and vertices") {
  const std::string text =
      head + "dataset polydata\n" + points +
      "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nTRIANGLE_STRIPS 1 5\n4 0 1 3 2\nPOLYGONS 1 4\n3 0 1 2\n";
  CHECK(parse_vtk_surface(text, "m.vtk").triangles == rows<Triangles>({0, 1, 3, 1, 2, 3, 0, 1, 2}));
}

TEST_CASE("VTK: a grid of every kind of face") {
  const std::string text = head + "DATASET UNSTRUCTURED_GRID\n" + points +
                           "CELLS 6 25\n3 0 1 2\n4 0 1 2 3\n4 0 1 3 2\n4 0 1 3 2\n1 0\n3 0 1 2\n"
                           "CELL_TYPES 6\n5\n9\n8\n6\n1\n7\nPOINT_DATA 4\nSCALARS s float\n";
  CHECK(parse_vtk_surface(text, "m.vtk").triangles ==
        rows<Triangles>({0, 1, 2, 0, 1, 2, 0, 2, 3, 0, 1, 2, 0, 2, 3, 0, 1, 3, 1, 2, 3, 0, 1, 2}));
}

TEST_CASE("VTK: numbers of other types, in binary") {
  Contents file(std::endian::big);
  file.text(vtk_header(true) + "DATASET UNSTRUCTURED_GRID\nPOINTS 3 short\n");
  for (const int number : {0, 0, 0, 1, 0, 0, 0, -1, 0}) file.bytes(static_cast<std::int16_t>(number));
  file.text("\nCELLS 1 4\n").bytes(3).bytes(0).bytes(2).bytes(1).text("\nCELL_TYPES 1\n").bytes(5).text("\n");
  const SurfaceMesh mesh = parse_vtk_surface(file.str(), "m.vtk");
  CHECK(mesh.vertices == rows<Points3>({0, 0, 0, 1, 0, 0, 0, -1, 0}));
  CHECK(mesh.triangles == rows<Triangles>({0, 2, 1}));
}

TEST_CASE("VTK: texture coordinates of points, in text and binary, whatever stands before them") {
  const std::string geometry = "DATASET POLYDATA\n" + points + "POLYGONS 1 5\n4 0 1 2 3\nPOINT_DATA 4\n";
  const std::string others =
      "SCALARS s float\nLOOKUP_TABLE default\n0 1 2 3\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\n";
  const Points2 expected = rows<Points2>({0, 0, 0.5, 0, 0.5, 1, 0, 1});
  for (const std::string& text :
       {geometry + others + "TEXTURE_COORDINATES uv 2 float\n0 0 0.5 0 0.5 1 0 1\n",
        geometry + "TEXTURE_COORDINATES uv 3 double\n0 0 9 0.5 0 9 0.5 1 9 0 1 9\n" + others}) {
    const SurfaceMesh mesh = parse_vtk_surface(head + text, "m.vtk");
    CHECK(mesh.uv == expected);
    CHECK(mesh.uv_triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
    ReadOptions without;
    without.read_uv = false;
    CHECK(parse_vtk_surface(head + text, "m.vtk", without).uv.rows() == 0);
  }
  // Those of cells are none of points, wherever they stand.
  const std::string cells = "CELL_DATA 1\nTEXTURE_COORDINATES c 2 float\n7 7\n",
                    faces = "DATASET POLYDATA\n" + points + "POLYGONS 1 5\n4 0 1 2 3\n",
                    own = "point_data 4\ntexture_coordinates uv 2 float\n0 0 0.5 0 0.5 1 0 1\n";
  CHECK(parse_vtk_surface(head + faces + cells, "m.vtk").uv.rows() == 0);
  CHECK(parse_vtk_surface(head + faces + "POINT_DATA 4\n" + cells, "m.vtk").uv.rows() == 0);
  CHECK(parse_vtk_surface(head + faces + cells + own, "m.vtk").uv == expected);
  CHECK(parse_vtk_surface(head + faces + own + cells, "m.vtk").uv == expected);
  Contents file(std::endian::big);
  file.text(vtk_header(true) + "DATASET POLYDATA\nPOINTS 3 float\n");
  for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) file.bytes(number);
  file.text("\nPOLYGONS 1 4\n").bytes(3).bytes(0).bytes(1).bytes(2);
  file.text("\nPOINT_DATA 3\nTEXTURE_COORDINATES uv 2 float\n");
  for (const float number : {0.f, 0.f, 2.f, 0.f, 0.f, 3.f}) file.bytes(number);
  CHECK(parse_vtk_surface(file.str(), "m.vtk").uv == rows<Points2>({0, 0, 2, 0, 0, 3}));
  refused(head + geometry + "TEXTURE_COORDINATES uv 1 float\n0 0 0 0\n",
          "m.vtk:11: texture coordinates of 1 numbers a point");
  refused(head + geometry + "TEXTURE_COORDINATES uv 2 float\n0 0 0 0 0\n",
          "m.vtk:11: number of texture coordinates 4 is more than the file can hold");
  refused(head + geometry + "TEXTURE_COORDINATES uv 2 float\n0 0 nan 0 0 1 1 1\n",
          "m.vtk:12: texture coordinate 'nan' is not finite");
}

TEST_CASE("VTK: faults are named by line, in binary data by byte") {
  const std::string poly = head + "DATASET POLYDATA\n";
  refused("", "m.vtk:1: not a VTK file: it does not begin with # vtk DataFile Version ");
  refused("# vtk DataFile Version 6.0\n", "m.vtk:1: version '6.0' is none of 1 to 5");
  refused("# vtk DataFile Version 3.0\nt\nHEX\n", "m.vtk:3: ASCII or BINARY expected, not 'hex'");
  refused("# vtk DataFile Version 3.0\nt\nASCII\nPOINTS\n", "m.vtk:4: DATASET expected");
  refused(head + "DATASET STRUCTURED_POINTS\n",
          "m.vtk:4: dataset 'structured_points' is neither POLYDATA nor UNSTRUCTURED_GRID");
  refused(poly, "m.vtk:4: no triangles");
  refused(poly + "POINTS 4 quad\n", "m.vtk:5: unknown type 'quad'");
  refused(poly + "POINTS 4000 float\n0 0 0\n",
          "m.vtk:5: number of points 4000 is more than the file can hold");
  refused(poly + "POINTS -1 float\n0 0 0\n", "m.vtk:5: number of points is negative: -1");
  refused(poly + "POINTS 2 float\n0 0 0 1.5 0\n", "m.vtk:6: missing z coordinate");
  refused(poly + "POINTS 2 float\n0 0 0\n1 nan 0\n", "m.vtk:7: y coordinate 'nan' is not finite");
  refused(poly + points + points, "m.vtk:8: POINTS for the second time");
  refused(poly + "POLYGONS 1 4\n3 0 1 2\n", "m.vtk:5: cells before POINTS");
  refused(poly + points + "POLYGONS 1 4\n3 0 1 4\n",
          "m.vtk:8: cell 0: point index 4 is out of range: there are 4");
  refused(poly + points + "POLYGONS 1 4\n3 0 1 -1\n",
          "m.vtk:8: cell 0: point index -1 is out of range: there are 4");
  refused(poly + points + "POLYGONS 1 3\n2 0 1\n", "m.vtk:8: cell 0: face with 2 vertices");
  refused(poly + points + "POLYGONS 1 3\n3 0 1 2\n", "m.vtk:9: cell 0 of 3 points with 2 integers left");
  refused(poly + points + "POLYGONS 1 5\n3 0 1 2 0\n", "m.vtk:9: 1 integers follow the last cell");
  refused(poly + points + "POLYGONS 2 1\n3 0 1 2 0\n", "m.vtk:8: more cells than integers");
  refused(poly + points + "TRIANGLE_STRIPS 1 3\n2 0 1\n", "m.vtk:8: cell 0: strip with 2 vertices");
  refused(poly + points + "NORMALS n float\n", "m.vtk:8: unknown keyword 'normals'");
  const std::string grid = head + "DATASET UNSTRUCTURED_GRID\n" + points;
  refused(grid + "CELLS 1 4\n3 0 1 2\n", "m.vtk:9: 0 cell types for 1 cells");
  refused(grid + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n",
          "m.vtk:11: no triangles: a mesh of 1 tetrahedron, to be read as such");
  const std::string five = vtk_header(false, "5.1") + "DATASET POLYDATA\n" + points;
  refused(five + "POLYGONS 2 3\nOFFSETS vtktypeint64\n1 3\nCONNECTIVITY vtktypeint64\n0 1 2\n",
          "m.vtk:8: offsets begin with 1 instead of 0");
  refused(five + "POLYGONS 3 3\nOFFSETS vtktypeint64\n0 4 3\nCONNECTIVITY vtktypeint64\n0 1 2\n",
          "m.vtk:8: offset 3 of a cell is below the one before");
  refused(five + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 2\nCONNECTIVITY vtktypeint64\n0 1 2\n",
          "m.vtk:8: offsets end at 2, there are 3 numbers in the cells");
  refused(five + "POLYGONS 2 3\nOFFSETS float\n0 2\n", "m.vtk:9: offsets are not of an integer type");
  refused(five + "POLYGONS 2 3\nCONNECTIVITY\n", "m.vtk:9: offsets expected");
  Contents file(std::endian::big);
  const std::string binary = vtk_header(true) + "DATASET POLYDATA\nPOINTS 1 double\n";
  file.text(binary).bytes(0.).bytes(std::numeric_limits<double>::quiet_NaN()).bytes(0.);
  refused(file.str(),
          ("m.vtk: byte " + std::to_string(binary.size() + 8) + ": y coordinate is not finite").c_str());
}

#include "contents.hpp"
#include "meshes.hpp"
#include "vtk_samples.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

std::string array(const std::string& attributes, const std::string& text,
                  const std::string& format = "ascii") {
  return "<DataArray " + attributes + " format=\"" + format + "\">" + text + "</DataArray>\n";
}

const std::string file_tag =
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n";
const std::string piece_tag = "<UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\n";
const std::string float_points = "type=\"Float32\" NumberOfComponents=\"3\"";
const std::string points = "<Points>\n" + array(float_points, "0 0 0 1 0 0 0 1 0") + "</Points>\n";
const std::string connectivity = array("type=\"Int32\" Name=\"connectivity\"", "0 1 2");
const std::string offsets = array("type=\"Int64\" Name=\"offsets\"", "3");
const std::string types = array("type=\"UInt8\" Name=\"types\"", "5");
const std::string end = "</Piece></UnstructuredGrid></VTKFile>\n";

std::string with_cells(const std::string& arrays) {
  return file_tag + piece_tag + points + "<Cells>\n" + arrays + "</Cells>\n" + end;
}

std::string with_points(const std::string& point_array) {
  return file_tag + piece_tag + "<Points>\n" + point_array + "</Points>\n<Cells>" + connectivity + offsets +
         types + "</Cells>\n" + end;
}

void refused(const std::string& contents, const char* message) {
  CAPTURE(contents);
  CHECK_THROWS_WITH_AS(parse_vtu_surface(contents, "m.vtu"), message, Error);
}

}  // namespace

TEST_CASE("VTU: pieces are joined") {
  const std::string piece = "<Piece NumberOfPoints='3' NumberOfCells='1'>" + points + "<Cells>" +
                            connectivity + offsets + types + "</Cells></Piece>";
  const SurfaceMesh mesh = parse_vtu_surface(file_tag + "<UnstructuredGrid>" + piece +
                                                 "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/>" + piece +
                                                 "</UnstructuredGrid></VTKFile>",
                                             "m.vtu");
  CHECK(mesh.vertices.rows() == 6);
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 2, 3, 4, 5}));
}

TEST_CASE("VTU: the texture coordinates that point data name") {
  const auto piece = [&](const std::string& point_data) {
    return "<Piece NumberOfPoints='3' NumberOfCells='1'>" + point_data + points + "<Cells>" + connectivity +
           offsets + types + "</Cells></Piece>";
  };
  const auto file = [&](const std::string& pieces) {
    return file_tag + "<UnstructuredGrid>" + pieces + "</UnstructuredGrid></VTKFile>";
  };
  const std::string other = array("type='Float64' Name='other' NumberOfComponents='2'", "7 7 7 7 7 7");
  const std::string two = array("type='Float32' Name='uv' NumberOfComponents='2'", "0 0 0.5 0 0 1");
  const std::string three = array("type='Float64' Name='uv' NumberOfComponents='3'", "0 0 9 0.5 0 9 0 1 9");
  const std::string named = "<PointData TCoords='uv'>", end_of_data = "</PointData>";
  const SurfaceMesh mesh = parse_vtu_surface(
      file(piece(named + other + two + end_of_data) + piece(named + three + end_of_data)), "m.vtu");
  CHECK(mesh.uv == rows<Points2>({0, 0, 0.5, 0, 0, 1, 0, 0, 0.5, 0, 0, 1}));
  CHECK(mesh.uv_triangles == mesh.triangles);
  CHECK(parse_vtu_surface(file(piece("<PointData>" + two + end_of_data)), "m.vtu").uv.rows() == 0);
  for (const std::string& pieces :
       {piece("") + piece(named + two + end_of_data), piece(named + two + end_of_data) + piece("")})
    CHECK_THROWS_WITH_AS(parse_vtu_surface(file(pieces), "m.vtu"),
                         doctest::Contains("texture coordinates in some pieces only"), Error);
  CHECK_THROWS_WITH_AS(
      parse_vtu_surface(file(piece(named + array("type='Float32' Name='uv'", "0 1 2") + end_of_data)),
                        "m.vtu"),
      doctest::Contains("texture coordinates need NumberOfComponents"), Error);
}

TEST_CASE("VTU: base64 of both lengths of header, in one stream or in parts, over several lines") {
  Contents data, narrow, wide;
  for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) data.bytes(number);
  narrow.bytes(std::uint32_t{36});
  wide.bytes(std::uint64_t{36});
  const std::string one = base64(narrow.str() + data.str());
  for (const std::string& text : {one, base64(narrow.str()) + base64(data.str()),
                                  "\n " + one.substr(0, 7) + "\r\n" + one.substr(7) + " "})
    CHECK(parse_vtu_surface(with_points(array(float_points, text, "binary")), "m.vtu").vertices(1, 0) == 1);
  std::string wide_file = with_points(array(float_points, base64(wide.str() + data.str()), "binary"));
  wide_file.insert(9, "header_type=\"UInt64\" ");
  CHECK(parse_vtu_surface(wide_file, "m.vtu").vertices(1, 0) == 1);
  refused(with_points(array(float_points, one.substr(0, 20) + "*" + one.substr(20), "binary")),
          "m.vtu:4: the data end early or are not base64");
  refused(with_points(array(float_points, one.substr(0, 21), "binary")),
          "m.vtu:4: the data end early or are not base64");
  refused(with_points(array(float_points, one.substr(0, 20), "binary")),
          "m.vtu:4: the data end early or are not base64");
  refused(with_points(array(float_points, one + "AAAA", "binary")),
          "m.vtu:4: the DataArray goes on behind its 36 bytes");
  refused(with_points(array(float_points, "AA==", "binary")),
          "m.vtu:4: the data end early or are not base64");
  refused(with_points(array("type=\"Float64\" NumberOfComponents=\"3\"", one, "binary")),
          "m.vtu:4: 36 bytes for 9 numbers of type Float64");
}

TEST_CASE("VTU: what is not understood is refused by line") {
  refused("", "m.vtu:1: not a VTK XML file: it has no VTKFile element");
  refused("<?xml version=\"1.0\"?>\n<html>", "m.vtu:2: not a VTK XML file: VTKFile expected");
  refused("<VTKFile type=\"PolyData\">", "m.vtu:1: file of type 'PolyData', not UnstructuredGrid");
  refused("<VTKFile type=\"UnstructuredGrid\" byte_order=\"PDP\">", "m.vtu:1: unknown byte_order 'PDP'");
  refused("<VTKFile type=\"UnstructuredGrid\" header_type=\"Int8\">", "m.vtu:1: unknown header_type 'Int8'");
  refused("<VTKFile type=UnstructuredGrid>", "m.vtu:1: value of attribute 'type' is not in quotes");
  refused("<VTKFile type>", "m.vtu:1: attribute 'type' without a value");
  refused("<VTKFile type=\"", "m.vtu:1: value of an attribute does not end");
  refused("<VTKFile", "m.vtu:1: the file ends within a tag");
  refused("<VTKFile\n<a>", "m.vtu:2: name expected in a tag");
  refused("\n<!DOCTYPE a []>", "m.vtu:2: document types and CDATA sections are not understood");
  refused("<!-- ", "m.vtu:1: comment does not end");
  refused(file_tag, "m.vtu:1: the file ends within the element 'VTKFile'");
  refused(file_tag + "</UnstructuredGrid>", "m.vtu:2: closing tag 'UnstructuredGrid' does not match");
  refused(file_tag + "</VTKFile>", "m.vtu:2: no triangles");
  refused(file_tag + "<Piece NumberOfPoints=\"many\"/>",
          "m.vtu:2: NumberOfPoints 'many' is not a number of items");
  refused(file_tag + "<Piece NumberOfPoints=\"-1\"/>",
          "m.vtu:2: NumberOfPoints '-1' is not a number of items");
  refused(file_tag + "<Piece NumberOfPoints=\"3000000000\"/>",
          "m.vtu:2: NumberOfPoints '3000000000' is too large");
  refused(file_tag + points + "</VTKFile>", "m.vtu:3: DataArray outside of a Piece");
  refused(file_tag + piece_tag + end, "m.vtu:2: Piece without Points");
  refused(file_tag + piece_tag + points + points + end, "m.vtu:7: DataArray for the second time");
  refused(with_cells(""), "m.vtu:2: Piece without connectivity");
  refused(with_cells(connectivity), "m.vtu:2: Piece without offsets");
  refused(with_cells(connectivity + offsets), "m.vtu:2: Piece without types");
  refused(with_cells(connectivity + offsets + array("type=\"UInt8\" Name=\"types\"", "10")),
          "m.vtu:7: cell 0: 1 tetrahedron of 3 nodes");
  refused(with_cells(array("type=\"Int32\" Name=\"connectivity\"", "0 1 3") + offsets + types),
          "m.vtu:7: cell 0: point index 3 is out of range: there are 3");
  refused(with_cells(array("type=\"Int32\" Name=\"connectivity\"", "0 -1 2") + offsets + types),
          "m.vtu:7: cell 0: point index -1 is out of range: there are 3");
  refused(with_cells(array("type=\"Float32\" Name=\"connectivity\"", "0 1 2") + offsets + types),
          "m.vtu:7: connectivity of the cells are not integers");
  refused(with_cells(array("type=\"Int32\" Name=\"connectivity\"", "0 1") + offsets + types),
          "m.vtu:7: connectivity 3 is more than the file can hold");
  refused(with_cells(array("type=\"Int32\" Name=\"connectivity\"", "0 1 2 0") + offsets + types),
          "m.vtu:7: more numbers in the DataArray than the file has items");
  refused(with_cells(connectivity + array("type=\"Int64\" Name=\"offsets\"", "-3") + types),
          "m.vtu:7: connectivity is negative: -3");
  refused(with_points(array("type=\"Float32\" NumberOfComponents=\"2\"", "0 0 1 0 0 1")),
          "m.vtu:4: points without NumberOfComponents=\"3\"");
  refused(with_points(array("type=\"Real\" NumberOfComponents=\"3\"", "0")),
          "m.vtu:4: DataArray of unknown type 'Real'");
  refused(with_points(array(float_points, "0 0 0 1 0 0 0 1")),
          "m.vtu:4: number of points 3 is more than the file can hold");
  refused(with_points(array(float_points, "0 0 0 1 0 0 0 1 nan")),
          "m.vtu:4: z coordinate 'nan' is not finite");
  refused(with_points(array(float_points, "AAAA", "zipped")),
          "m.vtu:4: DataArray of unknown format 'zipped'");
  std::string compressed = with_points(array(float_points, "AAAA", "binary"));
  compressed.insert(9, "compressor=\"vtkZLibDataCompressor\" ");
  refused(compressed, "m.vtu:4: the data end early or are not base64");
  refused(with_points("<DataArray " + float_points + " format=\"appended\" offset=\"0\"/>"),
          "m.vtu:4: the file has no AppendedData");
}

TEST_CASE("VTU: faults in appended data are named by byte") {
  std::string file = vtu_sample("appended", false).contents;
  const std::size_t start = file.find("  _") + 3;
  const auto at = [&](std::size_t offset, const char* what) {
    return "m.vtu: byte " + std::to_string(start + offset) + ": " + what;
  };
  std::string bad = file;
  bad[start + 3] = 8;
  refused(bad, at(0, "8 bytes for 12 numbers of type Float64").c_str());
  bad[start] = 8;
  refused(
      bad,
      at(0,
         ("array of 134217736 bytes, where " + std::to_string(file.size() - start - 4) + " are left").c_str())
          .c_str());
  bad = file;
  bad[start + 4] = '\x7f';
  bad[start + 5] = '\xf0';
  refused(bad, at(0, "point 0: x coordinate is not finite").c_str());
  bad = file;
  bad.replace(bad.find("raw"), 3, "hex");
  refused(bad, "m.vtu:17: appended data of encoding 'hex', which is neither raw nor base64");
  bad = file;
  bad[start - 1] = '-';
  refused(bad, "m.vtu:17: appended data do not begin with an underscore");
  bad = file;
  bad.replace(bad.find("offset='0'"), 10, "offset='9999'");
  refused(bad, "m.vtu:8: offset 9999 is beyond the end of the file");
  bad.replace(bad.find("offset='9999'"), 13, "offset='-1'");
  refused(bad, "m.vtu:8: offset '-1' is not a number");
}

TEST_CASE("VTU: pieces cannot share appended data and grow without bound") {
  std::string file = vtu_sample("appended", false).contents;
  const std::size_t begin = file.find("<Piece"), after = file.find("</UnstructuredGrid>");
  std::string piece = file.substr(begin, after - begin), pieces;
  for (int i = 0; i < 50; ++i) pieces += piece;
  file.replace(begin, after - begin, pieces);
  CHECK_THROWS_WITH_AS(parse_vtu_surface(file, "m.vtu"), doctest::Contains(": appended arrays overlap"),
                       Error);
}

namespace {

// As VTK 9.1 and meshio 5 write them by default; made with both.
const std::string vtk_default = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian" header_type="UInt32" compressor="vtkZLibDataCompressor">
  <UnstructuredGrid>
 <Piece NumberOfPoints="8" NumberOfCells="7" >
 <PointData>
 </PointData>
 <CellData>
 </CellData>
 <Points>
 <DataArray type="Float64" Name="Points" NumberOfComponents="3" format="appended" RangeMin="0" RangeMax="1.7916472867" offset="0" />
 </Points>
 <Cells>
 <DataArray type="Int64" Name="connectivity" format="appended" RangeMin="" RangeMax="" offset="80" />
 <DataArray type="Int64" Name="offsets" format="appended" RangeMin="" RangeMax="" offset="168" />
 <DataArray type="UInt8" Name="types" format="appended" RangeMin="" RangeMax="" offset="228" />
 </Cells>
 </Piece>
  </UnstructuredGrid>
  <AppendedData encoding="base64">
 _AQAAAACAAADAAAAAKAAAAA==eJxjYMAOZs0EgY/2OKSh4ANcHlX9B4L6sJuPru+DPXb1CHEA57gclQ==AQAAAACAAADQAAAALwAAAA==eJxjYIAARijNBKVZ0MSZ0eTZCehDl4eJs6LJ49LHxoAKYOoY0WiYOMx9ACDYAFA=AQAAAACAAAA4AAAAGwAAAA==eJxjYYAADijNA6UFoLQIlBaH0lJQGgAKmABuAQAAAACAAAAHAAAADQAAAA==eJzj4gICVlYAARAAPQ==
  </AppendedData>
</VTKFile>
)";
// Five points, and cells of which the arrays are given.
std::string meshio_file(int cells, const std::string& corners, const std::string& ends,
                        const std::string& kinds) {
  const auto data_array = [](const std::string& attributes, const std::string& data) {
    return "<DataArray " + attributes + " format=\"binary\">\n" + data + "\n</DataArray>\n";
  };
  return R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian" compressor="vtkZLibDataCompressor">
<!--This file was created by meshio v5.0.0-->
<UnstructuredGrid>
<Piece NumberOfPoints="5" NumberOfCells=")" +
         std::to_string(cells) + "\">\n<Points>\n" +
         data_array(R"(type="Float64" Name="Points" NumberOfComponents="3")",
                    "AQAAAACAAAB4AAAAFAAAAA==eJxjYMAHPtjjlSZaHpMGAPByBxs=") +
         "</Points>\n<Cells>\n" + data_array(R"(type="Int64" Name="connectivity")", corners) +
         data_array(R"(type="Int64" Name="offsets")", ends) +
         data_array(R"(type="Int64" Name="types")", kinds) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

const std::string meshio_default = meshio_file(
    2, "AQAAAACAAABAAAAAFwAAAA==eJxjYIAARijNBKWZ0cRZcMgDAAIIABE=",
    "AQAAAACAAAAQAAAADgAAAA==eJxjYYAADigNAACQAA0=", "AQAAAACAAAAQAAAADgAAAA==eJzjYoAALigNAAEAABU=");
const std::string meshio_mixed =
    meshio_file(4, "AQAAAACAAABwAAAAIAAAAA==eJxjYIAARijNBKWZCYizMKACmDwjmjiMD9MHAAW4ABg=",
                "AQAAAACAAAAgAAAAEwAAAA==eJxjYYAADijNDaX5oDQAAoAAJg==",
                "AQAAAACAAAAgAAAAEQAAAA==eJzjYoAALijNikYDAALIAB8=");

}  // namespace

TEST_CASE("VTU: as VTK and meshio write it by default, compressed and in base64") {
  const TetMesh vtk = parse_vtu_tets(vtk_default, "m.vtu");
  CHECK(vtk.vertices.rows() == 8);
  CHECK(vtk.vertices.rowwise().norm().maxCoeff() == doctest::Approx(1.7916472867));
  CHECK(vtk.tets.rows() == 5);
  CHECK(parse_vtu_elements(vtk_default, "m.vtu").elements.rows() == 5);
  const TetMesh meshio = parse_vtu_tets(meshio_default, "m.vtu");
  CHECK(meshio.vertices == rows<Points3>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}));
  CHECK(meshio.tets == rows<Tets>({0, 1, 2, 3, 1, 4, 2, 3}));
  CHECK(parse_vtu_tets(meshio_mixed, "m.vtu").tets.rows() == 2);
}

TEST_CASE("VTU: what is written compressed is read back, in blocks of every size") {
  SurfaceMesh mesh = crossed_grid(40, 40);
  for (const bool base64 : {false, true}) {
    const std::string text = format_vtu(mesh, {.vtu_base64 = base64, .vtu_compressed = true});
    CHECK(text.size() < format_vtu(mesh, {.vtu_base64 = base64}).size() / 2);
    const SurfaceMesh back = parse_vtu_surface(text, "m.vtu");
    CHECK(back.vertices == mesh.vertices);
    CHECK(back.triangles == mesh.triangles);
  }
  mesh.vertices.conservativeResize(8192, 3);  // whole blocks
  mesh.vertices.bottomRows(8192 - 3281).setZero();
  CHECK(parse_vtu_surface(format_vtu(mesh, {.vtu_compressed = true}), "m.vtu").vertices == mesh.vertices);
}

TEST_CASE("VTU: compressed data that lie are refused and take no memory") {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = meshio_default;
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
  };
  for (const char* name : {"vtkLZ4DataCompressor", "vtkLZMADataCompressor"})
    CHECK_THROWS_WITH_AS(
        parse_vtu_tets(with("vtkZLibDataCompressor", name), "m.vtu"),
        doctest::Contains((std::string("data compressed by '") + name + "' are not read").c_str()), Error);
  // A bomb: 2^31 - 1 points, and blocks that claim to hold them.
  CHECK_THROWS_WITH_AS(parse_vtu_tets(with("NumberOfPoints=\"5\"", "NumberOfPoints=\"2147483647\""), "m.vtu"),
                       doctest::Contains("120 bytes for 6442450941 numbers"), Error);
  const std::string header = "AQAAAACAAAB4AAAAFAAAAA==";
  CHECK_THROWS_WITH_AS(parse_vtu_tets(with(header, "AQAAAACAAAD///8fFAAAAA=="), "m.vtu"),
                       doctest::Contains("block 0 of 536870911 bytes, which is more than it can hold"),
                       Error);
  CHECK_THROWS_WITH_AS(parse_vtu_tets(with(header, "/////wCAAAB4AAAAFAAAAA=="), "m.vtu"),
                       doctest::Contains("4294967295 compressed blocks are more than the file can hold"),
                       Error);
  CHECK_THROWS_WITH_AS(parse_vtu_tets(with(header, "AQAAAACAAAB3AAAAFAAAAA=="), "m.vtu"),
                       doctest::Contains("block 0 is not compressed as zlib does"), Error);
  CHECK_THROWS_WITH_AS(
      parse_vtu_tets(with("eJxjYMAHPtjjlSZaHpMGAPByBxs=", "eJxjYMAHPtjjlSZaHpMGAPByBxs=AAAA"), "m.vtu"),
      doctest::Contains("the DataArray goes on behind its 120 bytes"), Error);
  CHECK_THROWS_WITH_AS(
      parse_vtu_tets(with("eJxjYMAHPtjjlSZaHpMGAPByBxs=", "eJxjYMAHPtjjlSZaHpMGAP"), "m.vtu"),
      doctest::Contains("the data end early or are not base64"), Error);
}

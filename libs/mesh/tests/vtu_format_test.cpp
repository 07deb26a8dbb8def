#include "formats.hpp"

#include <isostretch/core/error.hpp>

#include <doctest/doctest.h>

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
          "m.vtu:4: the data are not base64");
  refused(with_points(array(float_points, one.substr(0, 21), "binary")), "m.vtu:4: the data are not base64");
  refused(with_points(array(float_points, one.substr(0, 20), "binary")),
          "m.vtu:4: array of 36 bytes, where 11 are left");
  refused(with_points(array(float_points, one + "AAAA", "binary")),
          "m.vtu:4: array of 36 bytes, where 39 are left");
  refused(with_points(array(float_points, "AA==", "binary")), "m.vtu:4: the data end within their header");
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
  refused(compressed, "m.vtu:4: compressed data are not read: write the file without compression");
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
  bad.replace(bad.find("raw"), 3, "base64");
  refused(bad, "m.vtu:17: appended data of encoding 'base64': only raw is read");
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

// What all text formats have in common: ends of lines, byte-order marks, comments.
#include "contents.hpp"
#include "formats.hpp"
#include "log_lines.hpp"
#include "meshes.hpp"
#include "sample_mesh.hpp"
#include "surface_samples.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text) c == '\n' ? result += end : result += c;
  return result;
}

void same_as(const Sample& sample, const std::string& contents) {
  CAPTURE(sample.name);
  if (sample.tets) {
    const TetMesh mesh = parse_tets(sample.name, contents), wanted = parse_tets(sample.name, sample.contents);
    CHECK(mesh.vertices == wanted.vertices);
    CHECK(mesh.tets == wanted.tets);
  } else {
    const SurfaceMesh mesh = parse_surface(sample.name, contents),
                      wanted = parse_surface(sample.name, sample.contents);
    CHECK(mesh.vertices == wanted.vertices);
    CHECK(mesh.triangles == wanted.triangles);
  }
}

const std::string square_corners = "v 0 0 0\nv 1 0 0.1\nv 1 1 0.3\nv 0 1 0\n";

}  // namespace

TEST_CASE("every text format: lines end in any of three ways") {
  int checked = 0;
  for (const Sample& sample : all_samples()) {
    if (!sample.text) continue;
    ++checked;
    same_as(sample, with_line_ends(sample.contents, "\r\n"));
    same_as(sample, with_line_ends(sample.contents, "\r"));
  }
  CHECK(checked > 10);
}

TEST_CASE("every text format: a byte-order mark is passed over") {
  int checked = 0;
  for (const Sample& sample : all_samples()) {
    if (!sample.text) continue;
    ++checked;
    same_as(sample, "\xEF\xBB\xBF" + sample.contents);
    same_as(sample, "\xEF\xBB\xBF" + with_line_ends(sample.contents, "\r"));
  }
  CHECK(checked > 10);
}

TEST_CASE("every text format: faults name the line whatever ends it") {
  Variation variation;
  variation.corner = 77;
  int checked = 0;
  for (const Sample& sample : all_samples(variation)) {
    if (!sample.text || !sample.indexed) continue;
    ++checked;
    CAPTURE(sample.name);
    const auto message = [&](const std::string& contents) -> std::string {
      try {
        sample.tets ? void(parse_tets(sample.name, contents)) : void(parse_surface(sample.name, contents));
      } catch (const Error& error) {
        return error.what();
      }
      return "read";
    };
    const std::string plain = message(sample.contents);
    CHECK(plain != "read");
    CHECK(message(with_line_ends(sample.contents, "\r\n")) == plain);
    CHECK(message(with_line_ends(sample.contents, "\r")) == plain);
  }
  CHECK(checked > 10);
}

TEST_CASE("PLY: a binary file whose header has old line ends may begin with any byte") {
  Contents file(std::endian::little);
  file.text(
      "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty uchar x\rproperty uchar y\r"
      "property uchar z\relement face 1\rproperty list uchar uchar vertex_indices\rend_header\r");
  for (const int byte : {10, 0, 0, 20, 0, 0, 10, 5, 0, 3, 0, 1, 2})
    file.bytes(static_cast<std::uint8_t>(byte));
  const SurfaceMesh mesh = parse_ply(file.str(), "m.ply");
  CHECK(mesh.vertices == rows<Points3>({10, 0, 0, 20, 0, 0, 10, 5, 0}));
}

TEST_CASE("OBJ: a comment or a name ends with its line, though it ends in a backslash") {
  for (const char* statement :
       {"# exported from C:\\models\\", "o C:\\", "g a\\", "usemtl red\\", "mtllib C:\\a\\", "f 1 2 3 # C:\\",
        "v 9 9 9 # C:\\", "s off # \\", "\\", "# \\\\"}) {
    CAPTURE(statement);
    const SurfaceMesh mesh = parse_obj(square_corners + statement + "\nf 1 2 3\nf 1 3 4\n", "m.obj");
    CHECK(mesh.triangles.bottomRows(2) == rows<Triangles>({0, 1, 2, 0, 2, 3}));
  }
}

TEST_CASE("OBJ: numbers go on behind a backslash") {
  const SurfaceMesh mesh =
      parse_obj("v 0 0\\\n0\nv 1 \\\r\n 0 0.1\nv 1 1 0.3 1 \\\n 0 0\nf 1\\\r2 \\\n\\\n3\\", "m.obj");
  CHECK(mesh.vertices == rows<Points3>({0, 0, 0, 1, 0, 0.1, 1, 1, 0.3}));
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 2}));
  for (const char* statement :
       {"l 1 2 \\\n", "p 1 \\\n", "vn 0 0 \\\n", "vp 0 \\\n"})  // what follows is theirs
    CHECK(parse_obj(square_corners + statement + "f 1 2 3\nf 1 3 4\n", "m.obj").triangles.rows() == 1);
}

TEST_CASE("OBJ, OFF: a byte-order mark hides no vertex and no header") {
  const SurfaceMesh mesh =
      parse_obj("\xEF\xBB\xBFv 0 0 0\nv 1 0 0.1\nv 1 1 0.3\nv 0 1 0\nv 5 5 5\nf 1 2 3\nf 1 3 4\n", "m.obj");
  CHECK(mesh.vertices.rows() == 5);
  CHECK(mesh.vertices.row(mesh.triangles(0, 0)).isZero(0));
}

TEST_CASE("OFF: the number of vertices may follow the keyword without a blank") {
  for (const char* header :
       {"OFF4 2 0", "COFF4 2 0", "STOFF4 2", "NOFF4 2 5", "STCNOFF4 2 0", "OFF 4\t2", "OFF# c\n4 2"}) {
    CAPTURE(header);
    ReadOptions options;
    options.read_uv = false;  // there are none, whatever the header says
    const SurfaceMesh mesh = parse_off(
        header + std::string("\n0 0 0\n1 0 0.1\n1 1 0.3# c\n0 1 0\n3 0 1 2\n3 0 2 3\n"), "m.off", options);
    CHECK(mesh.vertices.rows() == 4);
    CHECK(mesh.triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
  }
  for (const char* header : {"4OFF 4 2 0", "OFFx", "nOFF4 2 0", "OFF-4 2 0"})
    CHECK_THROWS_WITH_AS(parse_off(header, "m.off"), doctest::Contains("m.off:1: not an OFF file"), Error);
}

TEST_CASE("VTK: names of components inside a field, and arrays of types that are not used") {
  const std::string text =
      "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\nFIELD FieldData 6\n"
      "dir 3 1 double\n0 0 1 \nMETADATA\nCOMPONENT_NAMES\nx\ny\nz\n\n"
      "METADATA 1 1 int\n3 \nwho 1 2 string\nsome%20body\n\nbits 1 3 bit\n1 0 1\nany 1 1 variant\n3 x\n"
      "odd 1 2 vtkSomethingNew\n1 2\nMETADATA\nINFORMATION 0\n\n"
      "POINTS 3 double\n0 0 0 1 0 0 0 1 0 \nPOLYGONS 2 3\nOFFSETS vtktypeint64\n0 3 \n"
      "CONNECTIVITY vtktypeint64\n0 1 2 \n";
  const SurfaceMesh mesh = parse_vtk_surface(text, "m.vtk");
  CHECK(mesh.vertices.rows() == 3);
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 2}));
}

TEST_CASE("VTK: texts and bits of a field in binary") {
  Contents file(std::endian::big);
  file.text(
          "# vtk DataFile Version 4.2\nvtk output\nBINARY\nDATASET POLYDATA\nFIELD FieldData 2\nwho 1 2 "
          "string\n")
      .bytes(static_cast<std::uint8_t>(3 << 6 | 2))
      .text("ab")
      .bytes(static_cast<std::uint16_t>(2 << 14 | 3))
      .text("abc")
      .text("\nbits 1 9 bit\n")
      .bytes(std::uint16_t{0x1234})
      .text("\nPOINTS 3 float\n");
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) file.bytes(x);
  file.text("\nPOLYGONS 1 4\n").bytes(3).bytes(0).bytes(1).bytes(2);
  CHECK(parse_vtk_surface(file.str(), "m.vtk").triangles == rows<Triangles>({0, 1, 2}));
}

TEST_CASE("STL: bytes behind the triangles that are counted are not read, with a warning") {
  const LogLines log;
  const std::string binary = stl_sample(true).contents;
  for (const std::string& tail : {std::string("x"), std::string(50, '\1'), std::string("\r\n")})
    CHECK(parse_stl(binary + tail, "m.stl").triangles.rows() == 2);
  CHECK(log.text().find("m.stl: 50 bytes follow the 2 triangles that the file counts") != std::string::npos);
  CHECK_THROWS_WITH_AS(parse_stl(binary.substr(0, binary.size() - 1), "m.stl"),
                       doctest::Contains("2 triangles of 50 bytes: 99 bytes follow"), Error);
}

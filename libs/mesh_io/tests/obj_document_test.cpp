#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/obj_document.hpp>

#include <doctest/doctest.h>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

// Groups, materials and colours; a quad with a normal, and a triangle that counts backwards.
const std::string text =
    "# C:\\models\\\nmtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0.2 0 0 1\nv 0 1 0 1 1 0\n"
    "v 2 0 0\nvt 9 9\nvt 8 8 # old\nvn 0 0 1\ng left\nusemtl red\ns 1\n  f 1/1/1 2/1/1 \\\n 3/1/1 4/1/1 # a "
    "quad\n"
    "g right\nusemtl blue\nf -4/1/-1 -1/2/1 -3/1/1\nl 1/1 2/2\n";

}  // namespace

TEST_CASE("OBJ document: everything but texture coordinates stays as it was") {
  const ObjDocument document = ObjDocument::parse(text, "m.obj");
  REQUIRE(document.mesh().triangles == rows<Triangles>({0, 1, 2, 0, 2, 3, 1, 4, 2}));
  const Points2 uv = rows<Points2>({0, 0, 1, 0, 1, 1, 0, 1, 2, 0});
  const ObjText out = document.with_uv(uv, document.mesh().triangles);
  CHECK(
      out.text ==
      "# C:\\models\\\nmtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0.2 0 0 1\nv 0 1 0 1 1 0\n"
      "v 2 0 0\n # old\nvn 0 0 1\ng left\nusemtl red\ns 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 0\n"
      "  f 1/1/1 2/2/1 3/3/1 4/4/1 # a quad\n"
      "g right\nusemtl blue\nf -4/2/-1 -1/5/1 -3/3/1\nl 1 2\n");
  CHECK(out.divided_faces == 0);
  CHECK(out.lines_without_uv == 1);
  const SurfaceMesh back = parse_obj(out.text, "m.obj");
  CHECK(back.vertices == document.mesh().vertices);
  CHECK(back.triangles == document.mesh().triangles);
  CHECK(back.uv == uv);
}

TEST_CASE("OBJ document: a polygon is divided where texture coordinates differ inside it") {
  const ObjDocument document = ObjDocument::parse(text, "m.obj");
  const Points2 uv = rows<Points2>({0, 0, 1, 0, 1, 1, 0, 1, 2, 0, 5, 5});
  Triangles corners = document.mesh().triangles;
  corners(1, 0) = 5;
  const ObjText out = document.with_uv(uv, corners);
  CHECK(out.divided_faces == 1);
  CHECK(out.text.find("  f 1/1/1 2/2/1 3/3/1\nf 1/6/1 3/3/1 4/4/1 # a quad\n") != std::string::npos);
  CHECK(parse_obj(out.text, "m.obj").uv_triangles == corners);
}

TEST_CASE("OBJ document: triangles left out take their faces along") {
  const ObjDocument document = ObjDocument::parse(text, "m.obj");
  const Points2 uv = rows<Points2>({0, 0, 1, 0, 1, 1, 0, 1, 2, 0});
  Triangles corners = document.mesh().triangles;
  corners.row(2).setConstant(-1);
  corners.row(0).setConstant(-1);
  const ObjText out = document.with_uv(uv, corners);
  CHECK(out.removed_faces == 1);
  CHECK(out.divided_faces == 1);
  const SurfaceMesh back = parse_obj(out.text, "m.obj");
  CHECK(back.triangles == rows<Triangles>({0, 2, 3}));
  CHECK(back.uv_triangles == rows<Triangles>({0, 2, 3}));
}

TEST_CASE("OBJ document: has the faces that reading has, whatever goes on in the next line") {
  const std::string model =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\\\nf 1 2 3\ng x\\\nf 1 2 3\nl 1/1 \\/2\nf 3 2 1\n";
  const ObjDocument document = ObjDocument::parse(model, "m.obj");
  CHECK(document.mesh().triangles == parse_obj(model, "m.obj").triangles);
  const ObjText out = document.with_uv(document.mesh().vertices.leftCols<2>(), document.mesh().triangles);
  CHECK(parse_obj(out.text, "m.obj").uv_triangles == document.mesh().triangles);
}

TEST_CASE("OBJ document: line ends stay, a file without any gets its own, a mark goes") {
  const ObjDocument document =
      ObjDocument::parse("\xEF\xBB\xBFv 0 0 0\rv 1 0 0\rv 0 1 0\rvt 0 0\rf 1 2 3\rf 1 1\r", "m.obj",
                         {.leave_out_faces = true, .read_uv = false});
  const ObjText out = document.with_uv(rows<Points2>({0, 0, 1, 0, 0, 1}), document.mesh().triangles);
  CHECK(out.text == "v 0 0 0\rv 1 0 0\rv 0 1 0\rvt 0 0\rvt 1 0\rvt 0 1\rf 1/1 2/2 3/3\r");
  CHECK(out.removed_faces == 1);
}

TEST_CASE("OBJ document: coordinates that do not fit are refused") {
  const ObjDocument document = ObjDocument::parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj");
  const Points2 uv = rows<Points2>({0, 0, 1, 0, 0, 1});
  CHECK_THROWS_WITH_AS(document.with_uv(uv, rows<Triangles>({0, 1, 3})), doctest::Contains("out of range"),
                       Error);
  CHECK_THROWS_WITH_AS(document.with_uv(uv, rows<Triangles>({0, 1, -1})), doctest::Contains("out of range"),
                       Error);
  CHECK_THROWS_WITH_AS(document.with_uv(uv, rows<Triangles>({0, 1, 2, 0, 1, 2})),
                       doctest::Contains("2 triangles"), Error);
}

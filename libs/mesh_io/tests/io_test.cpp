#include "meshes.hpp"
#include "scratch.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <clocale>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
namespace fs = std::filesystem;

namespace {

const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

void obj_refused(const std::string& text, const char* message) {
  CAPTURE(text);
  CHECK_THROWS_WITH_AS(parse_obj(text, "m.obj"), doctest::Contains(message), Error);
}

void off_refused(const std::string& text, const char* message) {
  CAPTURE(text);
  CHECK_THROWS_WITH_AS(parse_off(text, "m.off"), doctest::Contains(message), Error);
}

bool same_bits(const Points3& a, const Points3& b) {
  return a.rows() == b.rows() && (a.array() == b.array()).all();
}

}  // namespace

TEST_CASE("OBJ: vertices and faces in every form of corner") {
  const std::string uv = "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n";
  for (const char* face :
       {"f 1 2 3", "f 1/1 2/2 3/3", "f 1/1/1 2/2/1 3/3/1", "f 1//1 2//1 3//1", "f -3 -2 -1",
        "f -3/-3 -2/-2 -1/-1", "f -3//-1 -2//-1 -1//-1", "  f\t1  2 3  ", "f 1 2 3 # comment"}) {
    CAPTURE(face);
    const SurfaceMesh mesh = parse_obj(three + uv + face, "m.obj");
    CHECK(mesh.vertices.rows() == 3);
    CHECK(mesh.vertices(1, 0) == 1);
    CHECK(mesh.triangles == rows<Triangles>({0, 1, 2}));
    const std::string text(face);
    const bool with_uv = text.find('/') != std::string::npos && text.find("//") == std::string::npos;
    CHECK(mesh.has_uv() == with_uv);
    if (with_uv) {
      CHECK(mesh.uv_triangles == rows<Triangles>({0, 1, 2}));
      CHECK(mesh.uv(1, 0) == 1);
    }
  }
}

TEST_CASE("OBJ: what may surround the geometry is tolerated") {
  const SurfaceMesh mesh = parse_obj(
      "# comment\r\nmtllib a.mtl\r\no thing\r\ng part\r\ns off\r\n\r\nv 0 0 0 0.5 0.5 0.5\r\nv 1 0 0 1\r\n"
      "v 0 +1 0 # up\r\nusemtl red\r\nvp 1 2\r\nl 1 2\r\nf 1 \\\r\n 2 \\\r\n 3\r\n",
      "m.obj");
  CHECK(mesh.vertices == rows<Points3>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 2}));
}

TEST_CASE("OBJ: faces may come before their vertices") {
  CHECK(parse_obj("f 1 2 3\n" + three, "m.obj").triangles == rows<Triangles>({0, 1, 2}));
}

TEST_CASE("OBJ: numbers in every notation, below the range is zero") {
  const SurfaceMesh mesh = parse_obj("v 1e2 -.5 5.\nv 1E-400 1e-310 +3\nv 0 1 0\nf 1 2 3", "m.obj");
  CHECK(mesh.vertices.topRows(2) == rows<Points3>({100, -0.5, 5, 0, 1e-310, 3}));
}

TEST_CASE("OBJ: a one-dimensional texture coordinate gets v = 0") {
  const SurfaceMesh mesh = parse_obj(three + "vt 0.25\nvt 1 0 7\nvt 0 1\nf 1/1 2/2 3/3", "m.obj");
  CHECK(mesh.uv == rows<Points2>({0.25, 0, 1, 0, 0, 1}));
}

TEST_CASE("OBJ: polygons are cut into triangles, with their texture coordinates") {
  const std::string text = three + "v 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 4/3 3/4\n";
  const SurfaceMesh mesh = parse_obj(text, "m.obj");
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 3, 0, 3, 2}));
  CHECK(mesh.uv_triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
}

TEST_CASE("OBJ: faults are named by line") {
  obj_refused("", "m.obj:1: no vertices and no faces");
  obj_refused("# nothing\n\n", "no vertices and no faces");
  obj_refused(three, "m.obj:3: no faces");
  obj_refused("v 1 2\n", "m.obj:1: missing z coordinate");
  obj_refused("v 1 2 x\n", "m.obj:1: z coordinate 'x' is not a number");
  obj_refused("v 1 2 3x\n", "m.obj:1: z coordinate '3x' is not a number");
  obj_refused("v 1 2,5 3\n", "m.obj:1: y coordinate '2,5' is not a number");
  obj_refused("v 1 --2 3\n", "'--2' is not a number");
  obj_refused("v 1 +-2 3\n", "'+-2' is not a number");
  obj_refused("\nv 1 nan 3\n", "m.obj:2: y coordinate 'nan' is not finite");
  obj_refused("v inf 0 0\n", "m.obj:1: x coordinate 'inf' is not finite");
  obj_refused("v 0 0 -INF\n", "is not finite");
  obj_refused("v 1e999 0 0\n", "m.obj:1: x coordinate '1e999' is too large");
  obj_refused("v " + std::string(100, 'q') + " 0 0\n", "qqq...' is not a number");
  obj_refused("vt x\n", "m.obj:1: u coordinate 'x' is not a number");
  obj_refused(three + "f 1 2 4\n", "m.obj:4: vertex index 4 is out of range: there are 3");
  obj_refused(three + "f 1 2 3\nf 1 2 9\nf 1 2 7\n", "m.obj:5: vertex index 9");
  obj_refused(three + "f 1 2 -4\n", "m.obj:4: vertex index -4 reaches before the first of 3");
  obj_refused(three + "f 0 1 2\n", "m.obj:4: vertex index 0: OBJ counts from 1");
  obj_refused(three + "f 1 2 99999999999\n", "m.obj:4: vertex index '99999999999' is too large");
  obj_refused(three + "f 1 2\n", "m.obj:4: face with 2 vertices");
  obj_refused(three + "f\n", "m.obj:4: face with 0 vertices");
  obj_refused(three + "f 1 2 a\n", "m.obj:4: vertex index expected, not 'a'");
  obj_refused(three + "f 1 2 3.5\n", "m.obj:4: face corner is not of the form");
  obj_refused(three + "f 1 2 3/\n", "m.obj:4: texture index expected");
  obj_refused(three + "f 1 2 3//\n", "m.obj:4: normal index expected");
  obj_refused(three + "f 1/1/1/1 2 3\n", "face corner is not of the form");
  obj_refused(three + "f 1/1 2/1 3/1\n", "m.obj:4: texture index 1 is out of range: there are 0");
  obj_refused(three + "vt 0 0\nf 1/1 2/1 3\n", "m.obj:5: only some corners");
  obj_refused(three + "vt 0 0\nf 1/1 2/1 3/1\nf 1 2 3\n", "m.obj:6: face without texture coordinates");
  obj_refused(three + "vt 0 0\nf 1 2 3\nf 1/1 2/1 3/1\n", "m.obj:6: face with texture coordinates");
  obj_refused(three + "f 1 \\\n2 \\\nx\nf 1 2 3", "m.obj:6: vertex index expected, not 'x'");
  obj_refused(std::string("\0\1\2\3", 4), "no vertices and no faces");
  ReadOptions no_uv;
  no_uv.read_uv = false;
  CHECK_FALSE(parse_obj(three + "vt x\nf 1/1 2/1 3\nf 1 2 3\n", "m.obj", no_uv).has_uv());
}

TEST_CASE("OBJ: files that cannot be read") {
  const Scratch folder;
  CHECK_THROWS_WITH_AS(read_obj(folder.file("none.obj")),
                       doctest::Contains("none.obj: cannot read: No such file"), Error);
  CHECK_THROWS_WITH_AS(read_obj(fs::path(folder.file("x")).parent_path().string()),
                       doctest::Contains("cannot read"), Error);
  const std::string bad = folder.with("bad.obj", three + "f 1 2 4\n");
  CHECK_THROWS_WITH_AS(read_obj(bad), doctest::Contains((bad + ":4: vertex index 4").c_str()), Error);
}

TEST_CASE("OBJ: writing and reading gives the same bits") {
  const Scratch folder;
  SurfaceMesh mesh = procedural_face(12);
  std::mt19937_64 random(1);
  for (Eigen::Index i = 0; i < mesh.vertices.size(); ++i)  // every exponent a file can meet
    mesh.vertices.data()[i] *= std::ldexp(1.0 + 1e-3 * double(random() % 1000), int(random() % 2000) - 1000);
  mesh.vertices(0, 0) = 5e-324;
  mesh.vertices(0, 1) = -std::numeric_limits<double>::max();
  mesh.vertices(0, 2) = -0.0;
  const std::string path = folder.file("round.obj");
  write_obj(path, mesh);
  SurfaceMesh back = read_obj(path);
  CHECK(same_bits(back.vertices, mesh.vertices));
  CHECK(std::signbit(back.vertices(0, 2)));
  CHECK(back.triangles == mesh.triangles);
  CHECK_FALSE(back.has_uv());
  mesh.uv = mesh.vertices.leftCols<2>().array() * 0.1;
  mesh.uv_triangles = mesh.triangles.rowwise().reverse();
  write_obj(path, mesh);
  back = read_obj(path);
  CHECK(back.uv == mesh.uv);
  CHECK(back.uv_triangles == mesh.uv_triangles);
  CHECK(format_obj(back) == format_obj(mesh));
}

TEST_CASE("OBJ: what cannot be written is refused and leaves nothing behind") {
  const Scratch folder;
  const std::string path = folder.file("out.obj");
  SurfaceMesh mesh = square();
  mesh.vertices(2, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(write_obj(path, mesh), doctest::Contains("vertex 2 has a coordinate"), Error);
  mesh = square();
  mesh.triangles(1, 2) = 4;
  CHECK_THROWS_WITH_AS(write_obj(path, mesh),
                       doctest::Contains("triangle 1 (vertices 0 2 4): index out of range"), Error);
  mesh = square();
  mesh.uv_triangles = mesh.triangles.topRows(1);
  CHECK_THROWS_WITH_AS(write_obj(path, mesh), doctest::Contains("1 uv triangles for 2 triangles"), Error);
  CHECK(folder.empty());
  CHECK_THROWS_WITH_AS(write_obj(folder.file("no/such.obj"), square()), doctest::Contains("cannot write"),
                       Error);
}

TEST_CASE("OBJ: reading and writing do not depend on the locale") {
  const char* comma = std::setlocale(LC_ALL, "de_DE.UTF-8");
  if (!comma) MESSAGE("locale de_DE.UTF-8 is not installed: tested under the plain one");
  CHECK(parse_obj("v 0.5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "m.obj").vertices(0, 0) == 0.5);
  CHECK(format_obj(parse_obj("v 0.5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "m.obj")).substr(0, 9) == "v 0.5 0 0");
  std::setlocale(LC_ALL, "C");
}

TEST_CASE("OFF: plain, with comments, colours and counts on the first line") {
  for (const char* text :
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF 3 1 3\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2",
        "# c\nCOFF # c\n\n# c\n3 1\n0 0 0 255 0 0 255\n1 0 0 0 0 0 1\n\n0 1 0 # c\n 3 0 1 2 255 0 0\n"}) {
    CAPTURE(text);
    const SurfaceMesh mesh = parse_off(text, "m.off");
    CHECK(mesh.vertices == rows<Points3>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    CHECK(mesh.triangles == rows<Triangles>({0, 1, 2}));
  }
}

TEST_CASE("OFF: texture coordinates are the last two numbers of a vertex") {
  for (const char* text : {"STOFF\n3 1 0\n0 0 0 0.5 0\n1 0 0 1 0\n0 1 0 0 2\n3 0 1 2\n",
                           "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 0.5 0\n1 0 0 0 0 1 1 1 1 1 1 0 # c\n"
                           "0 1 0 0 0 1 9 9 9 9 0 2\n3 0 1 2 0 0 0\n"}) {
    const SurfaceMesh mesh = parse_off(text, "m.off");
    CHECK(mesh.uv == rows<Points2>({0.5, 0, 1, 0, 0, 2}));
    CHECK(mesh.uv_triangles == mesh.triangles);
    ReadOptions without;
    without.read_uv = false;
    CHECK(parse_off(text, "m.off", without).uv.rows() == 0);
  }
}

TEST_CASE("OFF: faults are named by line") {
  off_refused("STOFF\n3 1 0\n0 0 0 1\n1 0 0 0 0\n0 1 0 0 0\n3 0 1 2\n",
              "m.off:3: vertex without texture coordinates, which the first line promises");
  off_refused("STOFF\n3 1 0\n0 0 0 1 x\n1 0 0 0 0\n0 1 0 0 0\n3 0 1 2\n", "m.off:3: texture coordinate");
  const std::string head = "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  off_refused("", "m.off:1: no vertices and no faces");
  off_refused("PLY\n", "m.off:1: not an OFF file");
  off_refused("4OFF\n", "not an OFF file");
  off_refused("OFF\n", "m.off:1: the numbers of vertices and faces are missing");
  off_refused("OFF BINARY\n", "m.off:1: number of vertices expected, not 'BINARY'");
  off_refused("OFF\n3\n", "m.off:2: missing number of faces");
  off_refused("OFF\n-3 1 0\n", "number of vertices is negative");
  off_refused("OFF\n3 2000000000 0\n", "number of faces 2000000000 is more than the file can hold");
  off_refused("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "m.off:2: no faces");
  off_refused("OFF\n3 1 0\n0 0 0\n", "m.off:3: the file ends after 1 of 3 vertices");
  off_refused(head, "m.off:6: the file ends after 0 of 1 faces");
  off_refused("OFF\n3 1 0\n0 0\n", "m.off:3: missing z coordinate");
  off_refused("OFF\n3 1 0\n0 0 nan\n", "m.off:3: z coordinate 'nan' is not finite");
  off_refused(head + "3 0 1 4\n", "m.off:7: vertex index 4 is out of range: there are 4");
  off_refused(head + "3 0 1 -1\n", "m.off:7: vertex index -1 is out of range");
  off_refused(head + "3 0 1\n", "m.off:7: the face has fewer vertices than it says");
  off_refused(head + "3 0 1 2.5\n", "m.off:7: vertex index expected, not '2.5'");
  off_refused(head + "2 0 1\n", "m.off:7: face with 2 vertices");
  CHECK(parse_off(head + "4 0 1 3 2\n", "m.off").triangles == rows<Triangles>({0, 1, 3, 0, 3, 2}));
}

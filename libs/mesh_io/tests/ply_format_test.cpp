#include "contents.hpp"
#include "meshes.hpp"
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

const std::string vertices = "property float x\nproperty float y\nproperty float z\n";
const std::string faces = "property list uchar int vertex_indices\n";
const std::string head =
    "ply\nformat ascii 1.0\nelement vertex 3\n" + vertices + "element face 1\n" + faces + "end_header\n";
const std::string points = "0 0 0\n1 0 0\n0 1 0\n";

void refused(const std::string& contents, const char* message) {
  CAPTURE(contents);
  CHECK_THROWS_WITH_AS(parse_ply(contents, "m.ply"), message, Error);
}

}  // namespace

TEST_CASE("PLY: comments, other elements, other properties and CRLF") {
  const SurfaceMesh mesh = parse_ply(
      "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info none\r\nelement camera 1\r\nproperty "
      "float view\r\n"
      "property list int float matrix\r\nelement vertex 3\r\nproperty uchar red\r\nproperty double z\r\n"
      "property list uchar short seen_by\r\nproperty int x\r\nproperty float32 y\r\nproperty float s\r\n"
      "property float t\r\nelement empty 5\r\nelement face 1\r\nproperty float quality\r\n"
      "property list uint8 uint32 vertex_index\r\nproperty list uchar float texcoord\r\nelement edge 1\r\n"
      "property int vertex1\r\nproperty int vertex2\r\nend_header\r\n0.5 2 1 2\r\n"
      "255 0.25 0 0 0 9 9\r\n255 0.5 2 7 8 1 0 9 9\r\n\r\n255 1e-3 1 7 0 1 9 9\r\n0.5 3 0 1 2 6 0 0 1 0 0 "
      "1\r\n0 1\r\n",
      "m.ply");
  CHECK(mesh.vertices == rows<Points3>({0, 0, 0.25, 1, 0, 0.5, 0, 1, 1e-3}));
  CHECK(mesh.triangles == rows<Triangles>({0, 1, 2}));
}

TEST_CASE("PLY: binary numbers of every type in both byte orders") {
  for (const bool big : {false, true}) {
    Contents file(big ? std::endian::big : std::endian::little);
    file.text(std::string("ply\nformat binary_") + (big ? "big" : "little") +
              "_endian 1.0\nelement vertex 3\nproperty char x\nproperty ushort y\nproperty float z\n"
              "property list ushort double weights\nelement face 2\nproperty uint64 flags\n");
    CHECK_THROWS_WITH_AS(parse_ply(file.str(), "m.ply"), "m.ply:9: property of unknown type 'uint64'", Error);
    Contents good(big ? std::endian::big : std::endian::little);
    good.text(std::string("ply\nformat binary_") + (big ? "big" : "little") +
              "_endian 1.0\nelement vertex 3\nproperty char x\nproperty ushort y\nproperty float z\n"
              "property list ushort double weights\nelement face 2\nproperty short flags\n"
              "property list int uchar vertex_indices\nproperty uint more\nend_header\n");
    for (int v = 0; v < 3; ++v) {
      good.bytes(static_cast<std::int8_t>(-v)).bytes(static_cast<std::uint16_t>(60000 + v)).bytes(0.5f);
      good.bytes(static_cast<std::uint16_t>(v));
      for (int w = 0; w < v; ++w) good.bytes(1.5);
    }
    for (int f = 0; f < 2; ++f) {
      good.bytes(std::int16_t{7}).bytes(std::int32_t{3});
      for (const int corner : {0, 1 + f, 2 - f}) good.bytes(static_cast<std::uint8_t>(corner));
      good.bytes(std::uint32_t{9});
    }
    const SurfaceMesh mesh = parse_ply(good.str(), "m.ply");
    CHECK(mesh.vertices == rows<Points3>({0, 60000, 0.5, -1, 60001, 0.5, -2, 60002, 0.5}));
    CHECK(mesh.triangles == rows<Triangles>({0, 1, 2, 0, 2, 1}));
  }
}

TEST_CASE("PLY: polygons are cut into triangles") {
  const std::string text = "ply\nformat ascii 1.0\nelement vertex 4\n" + vertices + "element face 1\n" +
                           faces + "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  CHECK(parse_ply(text, "m.ply").triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
}

TEST_CASE("PLY: faults are named by line, in binary data by byte") {
  refused("", "m.ply:1: not a PLY file: it does not begin with ply");
  refused("plyx\n", "m.ply:1: not a PLY file: it does not begin with ply");
  refused("ply\n", "m.ply:1: the file ends within its header");
  refused("ply\nformat ascii 1.0\nelement vertex 3\n", "m.ply:3: the file ends within its header");
  refused("ply\nend_header\n", "m.ply:2: the header does not state a format");
  refused("ply\nformat utf8 1.0\n", "m.ply:2: unknown format 'utf8'");
  refused("ply\nformat ascii 1.0\nelements\n", "m.ply:3: unknown statement 'elements' in the header");
  refused("ply\nformat ascii 1.0\nelement vertex\n", "m.ply:3: missing number of elements");
  refused("ply\nformat ascii 1.0\nelement vertex -1\n" + vertices + "end_header\n",
          "m.ply:3: number of elements is negative: -1");
  refused("ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n",
          "m.ply:3: number of elements '99999999999999999999' is too large");
  refused("ply\nformat ascii 1.0\nelement vertex 1000\n" + vertices + "end_header\n",
          "m.ply:3: number of elements 1000 is more than the file can hold");
  refused("ply\nformat ascii 1.0\nproperty float x\n", "m.ply:3: property before the first element");
  refused("ply\nformat ascii 1.0\nelement a 1\nproperty float\n", "m.ply:4: property without a name");
  refused("ply\nformat ascii 1.0\nelement a 1\nproperty list float int a\n",
          "m.ply:4: the length of a list is not of an integer type");
  refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
          "m.ply:3: vertices have no property z");
  refused(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar float vertex_indices\nend_header\n3 0 0 "
      "0\n",
      "m.ply:3: faces have no list of integers vertex_indices or vertex_index");
  refused("ply\nformat ascii 1.0\nend_header\n", "m.ply:3: no vertices and no faces");
  refused("ply\nformat ascii 1.0\nelement vertex 3\n" + vertices + "end_header\n" + points,
          "m.ply:10: no faces");
  refused(head, "m.ply:3: number of elements 3 is more than the file can hold");
  refused(head + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "m.ply:11: missing z coordinate");
  refused(head + "0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n", "m.ply:11: z coordinate 'x' is not a number");
  refused(head + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "m.ply:11: z coordinate 'nan' is not finite");
  refused(head + "0 0 0\n1 0 1e999\n0 1 0\n3 0 1 2\n", "m.ply:11: z coordinate '1e999' is too large");
  refused(head + points + "3 0 1 3\n", "m.ply:13: vertex index 3 is out of range: there are 3");
  refused(head + points + "3 0 1 -1\n", "m.ply:13: vertex index -1 is out of range: there are 3");
  refused(head + points + "3 0 1\n", "m.ply:13: missing vertex index");
  refused(head + points + "3 0 1 2.5\n", "m.ply:13: vertex index expected, not '2.5'");
  refused(head + points + "2 0 1 2\n", "m.ply:13: face with 2 vertices");
  refused(head + points + "200 0 1\n", "m.ply:13: length of a list 200 is more than the file can hold");
  const std::string good = ply_sample("binary_little_endian").contents;
  const std::size_t data = good.find("end_header\n") + 11;
  const auto at = [&](std::size_t offset) { return "m.ply: byte " + std::to_string(data + offset) + ": "; };
  refused(good.substr(0, good.size() - 2),
          (at(4 * 24 + 13) + "length of a list 3 is more than the file can hold").c_str());
  refused(good.substr(0, good.size() - 13),
          (at(4 * 24 + 13) + "the file ends where the length of a list should be").c_str());
  std::string bad = good;
  bad[data + 24 + 7] = bad[data + 24 + 6] = '\x7f';  // an exponent of ones
  bad[data + 24 + 6] = '\xf0';
  refused(bad, (at(24) + "x coordinate is not finite").c_str());
  bad = good;
  bad[data + 4 * 24 + 1] = 4;
  refused(bad, (at(4 * 24 + 1) + "vertex index 4 is out of range: there are 4").c_str());
  bad[data + 4 * 24] = 1;
  refused(bad, (at(4 * 24) + "face with 1 vertices").c_str());
}

TEST_CASE("PLY: repeated elements are read as one, in time that grows as the file does") {
  constexpr int repeats = 50000;
  std::string header = "ply\nformat ascii 1.0\nelement vertex 3\n" + vertices, body = points;
  for (int i = 0; i < repeats; ++i) {
    header += "element face 1\n" + faces;
    body += "3 0 1 2\n";
  }
  CHECK(parse_ply(header + "end_header\n" + body, "m.ply").triangles.rows() == repeats);
}

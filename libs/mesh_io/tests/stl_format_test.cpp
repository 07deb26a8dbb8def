#include "contents.hpp"
#include "meshes.hpp"
#include "sample_mesh.hpp"
#include "surface_samples.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal 0 0 1\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c +
         "\n  endloop\n endfacet\n";
}

std::string solid(const std::string& facets) {
  return "solid part 7\n" + facets + "endsolid part 7\n";
}

void refused(const std::string& contents, const char* message, const ReadOptions& options = {}) {
  CAPTURE(contents);
  CHECK_THROWS_WITH_AS(parse_stl(contents, "m.stl", options), message, Error);
}

std::string text_of(const SurfaceMesh& mesh) {
  std::string facets;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    std::string corner[3];
    for (int c = 0; c < 3; ++c) {
      Contents text;
      for (int a = 0; a < 3; ++a) text.number(mesh.vertices(mesh.triangles(t, c), a)).text(" ");
      corner[c] = text.str();
    }
    facets += facet(corner[0], corner[1], corner[2]);
  }
  return solid(facets);
}

}  // namespace

TEST_CASE("STL: equal corners are one vertex, unless told otherwise") {
  const Sample sample = stl_sample(true);
  CHECK(parse_stl(sample.contents, "m.stl").vertices.rows() == 4);
  const SurfaceMesh apart = parse_stl(sample.contents, "m.stl", {.weld = false});
  CHECK(apart.vertices.rows() == 6);
  CHECK(apart.triangles == rows<Triangles>({0, 1, 2, 3, 4, 5}));
  CHECK(apart.vertices.row(3) == apart.vertices.row(0));
}

TEST_CASE("STL: a closed surface is closed again") {
  const SurfaceMesh sphere = icosphere(3);
  const SurfaceMesh back = parse_stl(text_of(sphere), "m.stl");
  CHECK(back.vertices.rows() == sphere.vertices.rows());
  CHECK(back.triangles.rows() == sphere.triangles.rows());
}

TEST_CASE("STL: zero of either sign is the same place") {
  const std::string text = solid(facet("0 0 0", "1 0 0", "0 1 0") + facet("-0 -0.0 0", "0 1 0", "-1 0 0"));
  CHECK(parse_stl(text, "m.stl").triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
}

TEST_CASE("STL: welding within a tolerance") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-1, 1);
  for (const double size : {1e-200, 1e-3, 1.0, 1e150}) {
    CAPTURE(size);
    SurfaceMesh soup = icosphere(2);
    const Eigen::Index vertices = soup.vertices.rows();
    const Points3 exact = soup.vertices;
    Points3 corners(soup.triangles.size(), 3);
    for (Eigen::Index i = 0; i < soup.triangles.size(); ++i) {
      for (int a = 0; a < 3; ++a)
        corners(i, a) = size * (exact(soup.triangles.data()[i], a) + 1e-6 * noise(random));
      soup.triangles.data()[i] = static_cast<int>(i);
    }
    soup.vertices = corners;
    const std::string text = text_of(soup);
    CHECK(parse_stl(text, "m.stl").vertices.rows() == corners.rows());
    const SurfaceMesh welded = parse_stl(text, "m.stl", {.weld_tolerance = 1e-5 * size});
    CHECK(welded.vertices.rows() == vertices);
    CHECK(welded.vertices.row(0) == corners.row(0));  // the first of those that became one
    // All in one place, and so little that no two numbers are that close: both end, and at once.
    CHECK(parse_stl(text, "m.stl", {.weld_tolerance = 1e9 * size}).vertices.rows() == 1);
    CHECK(parse_stl(text, "m.stl", {.weld_tolerance = 1e-320}).vertices.rows() == corners.rows());
  }
  refused(stl_sample(true).contents, "the welding tolerance is negative or not finite",
          {.weld_tolerance = -1});
  refused(stl_sample(true).contents, "the welding tolerance is negative or not finite",
          {.weld_tolerance = std::numeric_limits<double>::infinity()});
}

TEST_CASE("STL: text in capitals, of several solids, with polygons") {
  const std::string text = solid(facet("0 0 0", "1 0 0", "0 1 0")) +
                           "\r\n SOLID\r\nFacet\r\nOUTER LOOP\r\nVertex 0 0 0 "
                           "vertex 0 1 0\r\nVERTEX -1 0 0 ENDLOOP ENDFACET\r\nEndSolid\r\n";
  CHECK(parse_stl(text, "m.stl").triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
  std::string quad = solid(facet("0 0 0", "1 0 0", "1 1 0\nvertex 0 1 0"));
  CHECK(parse_stl(quad, "m.stl").triangles == rows<Triangles>({0, 1, 2, 0, 2, 3}));
}

TEST_CASE("STL: faults are named by line in text, by byte in binary") {
  const std::string good = facet("0 0 0", "1 0 0", "0 1 0");
  refused("", "m.stl: byte 0: the file ends within the header");
  refused("solid", "m.stl:1: the file ends where facet or endsolid should be");
  refused("solid a\n", "m.stl:1: the file ends where facet or endsolid should be");
  refused(solid(""), "m.stl:2: no faces");
  refused("solid a\n" + good, "m.stl:8: the file ends where facet or endsolid should be");
  refused(solid(good) + "triangle", "m.stl:10: solid expected, not 'triangle'");
  refused(solid(facet("0 0 0", "1 0 0", "0 1")), "m.stl:7: z coordinate 'endloop' is not a number");
  refused(solid(facet("0 0 0", "1 0 0", "0 1 nan")), "m.stl:6: z coordinate 'nan' is not finite");
  refused(solid(facet("0 0 0", "1 0 0", "0 1 -inf")), "m.stl:6: z coordinate '-inf' is not finite");
  refused(solid(facet("0 0 0", "1 0 0", "0 1 1e400")), "m.stl:6: z coordinate '1e400' is too large");
  refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n",
          "m.stl:6: facet with 2 vertices");
  refused("solid a\nfacet normal 0 0 1\nloop\n", "m.stl:3: outer expected, not 'loop'");
  refused("solid a\nfacet normal 0 0 1\nouter loop\nvortex\n",
          "m.stl:4: vertex or endloop expected, not 'vortex'");
  std::string binary = stl_sample(true).contents;
  CHECK(parse_stl(binary + "x", "m.stl").triangles.rows() == 2);
  refused(
      binary.substr(0, 100),
      "m.stl: byte 80: neither a text that begins with solid, nor 2 triangles of 50 bytes: 16 bytes follow");
  refused(binary.substr(0, 82), "m.stl: byte 80: the file ends where the number of triangles should be");
  binary[84 + 50 + 12 + 4 + 3] = '\x7f';
  binary[84 + 50 + 12 + 4 + 2] = '\x80';
  refused(binary, "m.stl: byte 150: y coordinate is not finite");
  refused(std::string(84, '\0'), "m.stl: byte 80: no faces");
}

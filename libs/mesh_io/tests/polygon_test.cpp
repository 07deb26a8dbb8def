#include "log_lines.hpp"
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

namespace {

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, " %.17g", x);
  return text;
}

// One face through the points, which may be turned into space.
std::string face_of(const std::vector<std::array<double, 2>>& points, const Eigen::Matrix3d& turn) {
  std::string text, face = "f";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = turn * Eigen::Vector3d(points[i][0], points[i][1], 3);
    text.append("v").append(number(p[0])).append(number(p[1])).append(number(p[2])).append("\n");
    face.append(" ").append(std::to_string(i + 1));
  }
  return text + face + "\n";
}

double shoelace(const std::vector<std::array<double, 2>>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto &a = p[i], &b = p[(i + 1) % p.size()];
    sum += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return sum;
}

// Triangles of the polygon, all turned like it: their areas with signs and without add up to its own.
void cut_right(const std::vector<std::array<double, 2>>& points) {
  Eigen::Matrix3d turn;
  turn << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
  for (const Eigen::Matrix3d& t : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), turn}) {
    const SurfaceMesh mesh = parse_obj(face_of(points, t), "m.obj");
    CHECK(mesh.triangles.rows() == static_cast<Eigen::Index>(points.size()) - 2);
    CHECK(total_area(mesh) == doctest::Approx(std::abs(shoelace(points))));
    double signed_sum = 0;
    for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i) {
      std::vector<std::array<double, 2>> corners;
      for (int c = 0; c < 3; ++c) corners.push_back(points[static_cast<std::size_t>(mesh.triangles(i, c))]);
      signed_sum += shoelace(corners);
    }
    CHECK(signed_sum == doctest::Approx(shoelace(points)));
  }
}

}  // namespace

TEST_CASE("polygons: concave ones are cut along diagonals inside") {
  cut_right({{0, 0}, {4, 0}, {1, 1}, {0, 4}});                  // an arrow head, from its tail
  cut_right({{1, 1}, {0, 4}, {0, 0}, {4, 0}});                  // from the notch
  cut_right({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});  // an L
  cut_right({{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}});  // a U
  cut_right({{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 0}});                  // clockwise
  cut_right({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}});                          // a vertex on an edge
  cut_right({{0, 0}, {1, 0}, {2, 0}, {1, 2}});                                  // a quad with one
  std::vector<std::array<double, 2>> star;
  for (int i = 0; i < 200; ++i) {
    const double radius = i % 2 == 0 ? 1 : 0.2, angle = 2 * M_PI * i / 200;
    star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  cut_right(star);
}

TEST_CASE("polygons: thousands of corners: disks, stars, saws, combs and spirals") {
  constexpr int count = 20000;  // of a disk's corners each sticks out by 5e-8 of its size
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> radius(0.3, 1);
  std::vector<std::array<double, 2>> disk, star, saw, comb, spiral;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count, own = radius(generator);
    disk.push_back({std::cos(angle), std::sin(angle)});
    star.push_back({(i % 2 == 0 ? 1 : 0.3) * std::cos(angle), (i % 2 == 0 ? 1 : 0.3) * std::sin(angle)});
    saw.push_back({own * std::cos(angle), own * std::sin(angle)});
    const bool back = i >= count / 2;
    comb.push_back(back ? std::array<double, 2>{0.5 * (count - 1 - i), 10}
                        : std::array<double, 2>{0.5 * i, i % 2 == 0 ? -5.0 : 9.0});
    const double turn = 30.0 * (back ? count - 1 - i : i) / count, out = 1 + turn + (back ? 0.5 : 0);
    spiral.push_back({out * std::cos(turn), out * std::sin(turn)});
  }
  for (const auto* points : {&disk, &star, &saw, &comb, &spiral}) cut_right(*points);
}

TEST_CASE("polygons: the better diagonal of a quad, the first of equally good ones") {
  CHECK(parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "m.obj").triangles ==
        rows<Triangles>({0, 1, 2, 0, 2, 3}));
  CHECK(parse_obj("v 0 0 0\nv 2 -0.5 0\nv 4 0 0\nv 2 0.5 0\nf 1 2 3 4\n", "m.obj").triangles ==
        rows<Triangles>({0, 1, 3, 1, 2, 3}));
}

TEST_CASE("polygons: a corner written twice on end is one") {
  CHECK(parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 3\nf 1 2 2 3\nf 1 2 3 1\n", "m.obj").triangles ==
        rows<Triangles>({0, 1, 2, 0, 1, 2, 1, 2, 0}));
}

TEST_CASE("polygons: what cannot be cut is refused by name, or left out") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\n";
  for (const char* face : {"f 1 3 2 4", "f 1 2 5 6", "f 1 2 1 2", "f 1 1 1 1"}) {
    CAPTURE(face);
    CHECK_THROWS_WITH_AS(parse_obj(points + face + "\n", "m.obj"),
                         doctest::Contains("m.obj:8: face 1 of 4 vertices crosses itself or has no area"),
                         Error);
    const LogLines log;
    CHECK(parse_obj(points + face + "\n", "m.obj", {.leave_out_faces = true}).triangles.rows() == 1);
    CHECK(log.text() == "m.obj: 1 face(s) that cross themselves or have no area left out\n");
  }
  const LogLines log;
  CHECK(parse_obj(points + "f 1 2\nf 1\nf 1 3 4\n", "m.obj", {.leave_out_faces = true}).triangles.rows() ==
        2);
  CHECK(log.text() == "m.obj: 2 face(s) of less than three vertices left out\n");
}

TEST_CASE("PLY: texture coordinates of vertices by every name, and of faces") {
  const std::string
      head =
          "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n",
      corners = "element face 2\nproperty list uchar int vertex_indices\n";
  for (const auto& [u, v] :
       {std::pair("s", "t"), {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
    const std::string text = head + "property float " + u + "\nproperty float " + v + "\n" + corners +
                             "end_header\n0 0 0 0 0\n1 0 0.1 1 0\n1 1 0.3 1 1\n0 1 0 0 1\n3 0 1 2\n3 0 2 3\n";
    const SurfaceMesh mesh = parse_ply(text, "m.ply");
    CHECK(mesh.uv == rows<Points2>({0, 0, 1, 0, 1, 1, 0, 1}));
    CHECK(mesh.uv_triangles == mesh.triangles);
    CHECK_FALSE(parse_ply(text, "m.ply", {.read_uv = false}).has_uv());
  }
  const std::string body = "0 0 0\n1 0 0.1\n1 1 0.3\n0 1 0\n",
                    list = "property list uchar float texcoord\nend_header\n";
  const SurfaceMesh mesh =
      parse_ply(head + corners + list + body + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0 1\n", "m.ply");
  CHECK(mesh.uv == rows<Points2>({0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1}));
  CHECK(mesh.uv_triangles == rows<Triangles>({0, 1, 2, 3, 4, 5}));
  CHECK_THROWS_WITH_AS(parse_ply(head + corners + list + body + "3 0 1 2 4 0 0 1 0\n3 0 2 3 0\n", "m.ply"),
                       doctest::Contains("m.ply:15: face with 3 vertices and 2 texture coordinates"), Error);
  CHECK_THROWS_WITH_AS(
      parse_ply(head + corners + list + body + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 0\n", "m.ply"),
      doctest::Contains("m.ply:16: face without texture coordinates"), Error);
}

TEST_CASE("PLY: texture coordinates are written, with the vertices where they have one each") {
  SurfaceMesh mesh = square();
  mesh.uv = mesh.vertices.leftCols<2>().array() / 3;
  mesh.uv_triangles = mesh.triangles;
  for (const Encoding encoding : {Encoding::text, Encoding::binary}) {
    const std::string text = format_ply(mesh, {.encoding = encoding});
    CHECK(text.find("property double s\nproperty double t\n") != std::string::npos);
    const SurfaceMesh back = parse_ply(text, "m.ply");
    CHECK(back.uv == mesh.uv);
    CHECK(back.uv_triangles == mesh.uv_triangles);
    SurfaceMesh seam = mesh;
    seam.uv.conservativeResize(5, 2);
    seam.uv.row(4) << 7, 8;
    seam.uv_triangles(1, 0) = 4;
    const SurfaceMesh cut = parse_ply(format_ply(seam, {.encoding = encoding}), "m.ply");
    REQUIRE(cut.uv_triangles.rows() == 2);
    for (int t = 0; t < 2; ++t)
      for (int c = 0; c < 3; ++c)
        CHECK(cut.uv.row(cut.uv_triangles(t, c)) == seam.uv.row(seam.uv_triangles(t, c)));
  }
}

#include <isostretch/figures/html.hpp>

#include <isostretch/core/base64.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/figures/axis.hpp>
#include <isostretch/figures/camera.hpp>
#include <isostretch/figures/canvas.hpp>
#include <isostretch/figures/checkerboard.hpp>
#include <isostretch/figures/comparison_plot.hpp>
#include <isostretch/figures/distortion_scale.hpp>
#include <isostretch/figures/model_view.hpp>
#include <isostretch/figures/raster.hpp>
#include <isostretch/figures/utf8.hpp>
#include <isostretch/figures/visibility.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/edges.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace isostretch;
using namespace isostretch::figures;
using doctest::Approx;

namespace {

const std::vector<int> none;

ModelData data(const mesh::SurfaceMesh& model, const mesh::Points2& uv,
               const std::vector<int>& flipped = none) {
  return {model.vertices, model.triangles, uv, model.triangles, 0.25, flipped};
}

// Of a disc in the unit ball seen from straight ahead.
std::vector<std::uint32_t> view_of(const ModelData& model) {
  const Camera camera({Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()}, 0, 0);
  const mesh::Points3 normals = smooth_normals(model.vertices, model.triangles);
  return draw_view(model, normals, camera, {60, {20, 20}}, 40, 40).picture.pixels();
}

int blue_minus_red(std::uint32_t pixel) {
  return static_cast<int>(pixel & 255U) - static_cast<int>(pixel >> 16U & 255U);
}

}  // namespace

TEST_CASE("text for reports") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");
  CHECK(with_thousands(0) == "0");
  CHECK(with_thousands(-999) == "-999");
  CHECK(with_thousands(1234567) == "1,234,567");
  CHECK(with_thousands(-123456) == "-123,456");
  CHECK(valid_utf8("ä\xff\"\\") == "ä\uFFFD\"\\");
  CHECK(html::escaped("<a href=\"x\">&'\x01") == "&lt;a href=&quot;x&quot;&gt;&amp;&#39;\uFFFD");
}

TEST_CASE("the nearer triangle is seen, whatever comes first, and lines that it does not hide") {
  const ScreenPoint near[] = {{0, 0, 0.5}, {9, 0, 0.5}, {0, 9, 0.5}},
                    far[] = {{0, 0, 0.2}, {9, 0, 0.2}, {0, 9, 0.2}};
  for (const bool near_first : {true, false}) {
    Visibility seen(10, 10);
    if (near_first) seen.add_triangle(1, near[0], near[1], near[2]);
    seen.add_triangle(0, far[0], far[1], far[2]);
    if (!near_first) seen.add_triangle(1, near[0], near[1], near[2]);
    CHECK(seen.at(2, 2) == 1);
    CHECK(seen.at(9, 9) == Visibility::nothing);
    seen.add_line({0, 2.5, 0.499}, {9, 2.5, 0.499}, 1, 0.01);
    CHECK(seen.at(2, 2) == Visibility::line);
    seen.add_line({0, 4.5, 0.3}, {9, 4.5, 0.3}, 1, 0.01);
    CHECK(seen.at(2, 4) == 1);
    CHECK(seen.sees({2.5, 4.5, 0.5}, 0.01));
    CHECK_FALSE(seen.sees({2.5, 4.5, 0.3}, 0.01));
  }
}

TEST_CASE("slivers, points and what is not finite are drawn without harm") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  Visibility seen(10, 10);
  seen.add_triangle(0, {1, 1, 0.3}, {1, 1, 0.3}, {1, 1, 0.3});
  seen.add_triangle(1, {0, 0, 0.3}, {5, 5, 0.3}, {9, 9, 0.3});
  seen.add_triangle(2, {nan, 0, 0.3}, {5, 5, 0.3}, {9, 0, nan});
  seen.add_line({1, 1, 0.3}, {1, 1, 0.3}, 0, 0);
  CHECK(seen.at(0, 9) == Visibility::nothing);
  CHECK_FALSE(seen.sees({-5, 20, -1}, 0));
  CHECK(checker_color(nan, inf).r == checker_light.r);

  // All vertices in one place, and no normals.
  mesh::SurfaceMesh point = mesh::disc(1);
  point.vertices.setConstant(7);
  point.vertices = in_unit_ball(point.vertices, point.triangles);
  CHECK(point.vertices.isZero(0));
  CHECK(smooth_normals(point.vertices, point.triangles).isZero(0));
  const auto pixels = view_of(data(point, mesh::Points2::Zero(point.vertices.rows(), 2)));
  CHECK(std::all_of(pixels.begin(), pixels.end(), [&](auto p) { return p == pixels[0]; }));
}

TEST_CASE("any model comes to lie in the unit ball, and vertices of no triangle do not count") {
  mesh::SurfaceMesh ball = mesh::icosphere(1);
  const Eigen::Index all = ball.vertices.rows();
  ball.vertices.conservativeResize(all + 1, 3);
  for (const double scale : {1e-200, 1.0, 1e200}) {
    mesh::Points3 vertices = scale * (ball.vertices.rowwise() + Eigen::RowVector3d(3, 4, 5));
    vertices.row(all) << 1e300, -1e300, 1e300;
    vertices = in_unit_ball(vertices, ball.triangles);
    CHECK(vertices.rowwise().norm().maxCoeff() <= 1 + 1e-12);
    CHECK(vertices.topRows(all).rowwise().norm().minCoeff() > 0.5);
  }
}

TEST_CASE("the pose is that of the field's models unless the model says otherwise") {
  const auto up_of = [](const mesh::SurfaceMesh& model) {
    return guess_pose(model.vertices, model.triangles).up;
  };
  const mesh::SurfaceMesh ball = mesh::icosphere(2);
  CHECK(up_of(ball) == Eigen::Vector3d::UnitY());
  // Cut flat below in z: stands there.
  mesh::SurfaceMesh standing = ball;
  standing.vertices.col(2) = standing.vertices.col(2).cwiseMax(-0.3);
  CHECK(up_of(standing) == Eigen::Vector3d::UnitZ());
  // A sheet on the ground is seen from above, one on a wall from the front.
  mesh::SurfaceMesh sheet = mesh::disc(3);
  CHECK(guess_pose(sheet.vertices, sheet.triangles).front.z() == Approx(1));
  sheet.vertices.col(1).swap(sheet.vertices.col(2));
  const Pose pose = guess_pose(sheet.vertices, sheet.triangles);
  CHECK(std::abs(pose.front.y()) == Approx(1));
  CHECK(pose.right().norm() == Approx(1));
}

TEST_CASE("a surface is seen with its checkerboard, flipped triangles in their colour") {
  mesh::SurfaceMesh disc = mesh::disc(4);
  disc.vertices /= disc.vertices.rowwise().norm().maxCoeff();
  const mesh::Points2 uv = disc.vertices.leftCols(2);
  const auto pixels = view_of(data(disc, uv));
  // Squares of 3.75 pixels, so that these two lie in neighbours.
  const int here = blue_minus_red(pixels[40 * 22 + 21]), next = blue_minus_red(pixels[40 * 22 + 25]);
  CHECK(std::abs(here - next) > 20);
  CHECK(blue_minus_red(pixels[0]) >= 0);  // the ground
  std::vector<int> every(static_cast<std::size_t>(disc.triangles.rows()));
  for (std::size_t t = 0; t < every.size(); ++t) every[t] = static_cast<int>(t);
  CHECK(blue_minus_red(view_of(data(disc, uv, every))[40 * 22 + 21]) > 100);
}

TEST_CASE("edges are told apart") {
  const mesh::Edges edges = mesh::edges_of(mesh::icosphere(0).triangles);
  CHECK(edges.inner.size() == 30);
  CHECK(edges.boundary.empty());
  CHECK(mesh::edges_of(mesh::disc(1).triangles).boundary.size() == 6);
}

TEST_CASE("axes have a few round ticks inside their range") {
  const Axis axes[] = {linear_axis(27, 6, true),    linear_axis(0.003, 5),      linear_axis(0, 5),
                       linear_axis(1, 6, true),     decade_axis(1e-16, 1e9, 9), decade_axis(3, 3, 9),
                       narrow_log_axis(4, 4.04, 8), narrow_log_axis(4, 30, 8),  narrow_log_axis(4, 4e8, 8)};
  for (const Axis& axis : axes) {
    CHECK(axis.ticks.size() >= 2);
    int labels = 0;
    for (const Tick& tick : axis.ticks) {
      CHECK(axis.position(tick.value) >= -1e-9);
      CHECK(axis.position(tick.value) <= 1 + 1e-9);
      labels += !tick.label.empty();
    }
    CHECK(labels >= 2);
    CHECK(labels <= 11);
  }
  CHECK(axes[0].ticks[0].label == "0");
}

TEST_CASE("the distortion scale shares out the whole area") {
  const double inf = std::numeric_limits<double>::infinity();
  const DistortionScale scale = distortion_scale({4, 4.5, 5, inf}, {1, 1, 1, 0.001}, 10);
  double sum = 0;
  for (const double share : scale.shares) sum += share;
  CHECK(sum == Approx(1));
  CHECK(scale.above);
  CHECK(scale.axis.high == 5);
  CHECK(distortion(1, 1) == 4);
  CHECK(distortion(2, 0) == inf);
}

TEST_CASE("triangles that share an edge leave no gap and cover nothing else") {
  Raster raster(8, 8, {0, 0, 0});
  raster.fill_triangle({1, 1, 7, 1, 7, 7}, {1, 1, 1});
  raster.fill_triangle({1, 1, 7, 7, 1, 7}, {1, 1, 1});
  raster.fill_triangle({-1e300, 0, std::nan(""), 1, 1e300, 2}, {1, 0, 0});
  raster.fill_triangle({20, 20, 30, 20, 20, 30}, {1, 0, 0});
  const auto pixels = raster.pixels();
  for (int y = 2; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      CHECK(pixels[static_cast<std::size_t>(8 * y + x)] == (x > 0 && x < 7 && y < 7 ? 0xFFFFFFU : 0U));
}

TEST_CASE("long titles are shortened between characters") {
  Canvas canvas(200, 50);
  const std::string text = canvas.shortened("äöüäöüäöüäöüäöüäöüäöüäöüäöü", 100);
  CHECK(text.find("…") != std::string::npos);
  CHECK(canvas.text_width(text) <= 100);
  CHECK(canvas.shortened("short", 100) == "short");
  CHECK(canvas.file().substr(1, 3) == "PNG");
}

TEST_CASE("comparisons are drawn as pixels and as shapes, whatever the numbers") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  ComparisonPanel empty{"empty", "x", true, true, {{}, {}}};
  ComparisonPanel odd{"odd", "x", true, true, {{{0, 0}, {1, nan}, {2, inf}, {3, 1e-300}}, {{1, 1}}}};
  odd.lowest_y = 1e-13;
  odd.levels = {1e-4, 1e30};
  const std::vector<std::string> names{"one & <two>", ""};
  const auto draw = [&](PictureFormat format) {
    return draw_comparison("title", "subtitle", names, {empty, odd}, 2, format);
  };
  CHECK(draw(PictureFormat::png).substr(1, 3) == "PNG");
  const std::string svg = draw(PictureFormat::svg);
  CHECK(svg.find("<svg") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
}

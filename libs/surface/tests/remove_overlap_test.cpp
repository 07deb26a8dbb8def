// Layouts rid of their overlap: sides of a cut moved apart, and charts divided.
#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/overlap.hpp>
#include <isostretch/surface/seams.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;

namespace {

// A strip that winds around the origin, n quads a turn; with a vertex of height its turns lie over each
// other.
SurfaceMesh ramp(int n, int turns) {
  const int steps = n * turns;
  SurfaceMesh mesh;
  mesh.vertices.resize(2 * (steps + 1), 3);
  mesh.triangles.resize(2 * steps, 3);
  for (int i = 0; i <= steps; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    for (int side = 0; side < 2; ++side)
      mesh.vertices.row(2 * i + side) << (1 + side) * std::cos(angle), (1 + side) * std::sin(angle),
          0.1 * i / n;
  }
  for (int i = 0; i < steps; ++i) {
    mesh.triangles.row(2 * i) << 2 * i, 2 * i + 1, 2 * i + 3;
    mesh.triangles.row(2 * i + 1) << 2 * i, 2 * i + 3, 2 * i + 2;
  }
  return mesh;
}

// What split_overlap promises of every layout.
void check_division(const Cut& before, const Cut& after, const Division& division, const Points2& uv) {
  CHECK(after.mesh.vertices.rows() == static_cast<Eigen::Index>(division.previous_vertex.size()));
  CHECK(division.previous_chart.size() == after.charts.size());
  Points2 carried(after.mesh.vertices.rows(), 2);
  for (std::size_t v = 0; v < division.previous_vertex.size(); ++v)
    carried.row(static_cast<Eigen::Index>(v)) = uv.row(division.previous_vertex[v]);
  for (Eigen::Index t = 0; t < after.mesh.triangles.rows(); ++t)
    for (int c = 0; c < 3; ++c)
      CHECK(division.previous_vertex[static_cast<std::size_t>(after.mesh.triangles(t, c))] ==
            before.mesh.triangles(t, c));
  int triangles = 0;
  for (std::size_t c = 0; c < after.charts.size(); ++c) {
    std::vector<int> label;
    for (const int chart : after.chart) label.push_back(chart == static_cast<int>(c) ? 0 : 1);
    const Part part = split(after.mesh, label).front();
    Points2 own(part.mesh.vertices.rows(), 2);
    for (std::size_t v = 0; v < part.original_vertex.size(); ++v)
      own.row(static_cast<Eigen::Index>(v)) = carried.row(part.original_vertex[v]);
    CHECK(overlapping_pairs(own, part.mesh.triangles).empty());
    CHECK(boundary_loops(part.mesh).size() == static_cast<std::size_t>(after.charts[c].loops));
    CHECK(part.mesh.triangles.rows() == after.charts[c].triangles);
    triangles += after.charts[c].triangles;
  }
  CHECK(triangles == after.mesh.triangles.rows());
}

}  // namespace

TEST_CASE("part_sides: a cut that stays closed but for rounding is opened by a hair") {
  const SurfaceMesh mesh = grid(10, 10);
  Cut cut = cut_to_disks(mesh);
  int middle = -1;
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v)
    if ((mesh.vertices.row(v) - Eigen::RowVector3d(0.5, 0.5, 0)).norm() < 1e-9) middle = static_cast<int>(v);
  REQUIRE(middle >= 0);
  extend_cut(cut, middle);
  std::mt19937 generator(2);
  std::normal_distribution<double> normal(0, 1e-8);
  Points2 uv = cut.mesh.vertices.leftCols(2);
  for (Eigen::Index i = 0; i < uv.size(); ++i) uv.data()[i] += normal(generator);
  const Points2 before = uv;
  REQUIRE(!overlapping_pairs(uv, cut.mesh.triangles).empty());
  const int moved = part_sides(uv, cut.mesh.triangles, 1e-6);
  CHECK(moved > 2);
  CHECK(moved <= 2 * static_cast<int>(cut.seams.size() + 1));
  CHECK((uv - before).rowwise().norm().maxCoeff() < 1.001e-6);
  CHECK(overlapping_pairs(uv, cut.mesh.triangles).empty());
  CHECK(part_sides(uv, cut.mesh.triangles, 1e-6) == 0);
}

TEST_CASE("part_sides turns no triangle over, however far it should move") {
  const SurfaceMesh mesh = ramp(40, 2);
  Points2 uv = mesh.vertices.leftCols(2);
  part_sides(uv, mesh.triangles, 100);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::RowVector2d a = uv.row(mesh.triangles(t, 1)) - uv.row(mesh.triangles(t, 0)),
                             b = uv.row(mesh.triangles(t, 2)) - uv.row(mesh.triangles(t, 0));
    CHECK(a.x() * b.y() - a.y() * b.x() > 0);
  }
}

TEST_CASE("split_overlap: a ramp of two and a half turns becomes three charts, cut across") {
  const SurfaceMesh mesh = ramp(40, 3);
  SurfaceMesh part = mesh;
  part.triangles = mesh.triangles.topRows(200).eval();  // two and a half turns
  Cut cut = cut_to_disks(part);
  const Cut before = cut;
  const Points2 uv = mesh.vertices.leftCols(2);
  const Points2 layout = uv.topRows(before.mesh.vertices.rows());
  const Division division = split_overlap(cut, layout);
  check_division(before, cut, division, layout);
  CHECK(cut.charts.size() == 3);
  CHECK(seam_length(part.vertices, cut.seams) < 2.5);  // the strip is 1 wide
}

TEST_CASE("split_overlap: nothing is cut where nothing overlaps") {
  Cut cut = cut_to_disks(disc(6));
  const Cut before = cut;
  const Division division = split_overlap(cut, before.mesh.vertices.leftCols(2));
  CHECK(division.previous_vertex.size() == before.original_vertex.size());
  CHECK(cut.charts.size() == 1);
  CHECK(cut.seams.empty());
  CHECK(cut.mesh.triangles == before.mesh.triangles);
}

TEST_CASE("split_overlap: two arms that cross are parted at the narrowest place of one") {
  // A long strip, laid so that its ends cross, with a neck before one of them.
  const int n = 120;
  SurfaceMesh mesh;
  mesh.vertices.resize(2 * (n + 1), 3);
  mesh.triangles.resize(2 * n, 3);
  Points2 uv(2 * (n + 1), 2);
  for (int i = 0; i <= n; ++i) {
    const double angle = 2 * std::numbers::pi * (1.2 * i / n - 0.1), radius = 4 + 1.0 * i / n;
    const double width = i == 20 ? 0.1 : 1;
    for (int side = 0; side < 2; ++side) {
      const double r = radius + width * side;
      uv.row(2 * i + side) << r * std::cos(angle), r * std::sin(angle);
      mesh.vertices.row(2 * i + side) << uv(2 * i + side, 0), uv(2 * i + side, 1), 0;
    }
  }
  for (int i = 0; i < n; ++i) {
    mesh.triangles.row(2 * i) << 2 * i, 2 * i + 1, 2 * i + 3;
    mesh.triangles.row(2 * i + 1) << 2 * i, 2 * i + 3, 2 * i + 2;
  }
  REQUIRE(!overlapping_pairs(uv, mesh.triangles).empty());
  Cut cut = cut_to_disks(mesh);
  const Cut before = cut;
  check_division(before, cut, split_overlap(cut, uv), uv);
  CHECK(cut.charts.size() == 2);
  CHECK(cut.seams == std::vector<Edge>{{40, 41}});
}

TEST_CASE("split_overlap: folds, spikes and noise of every strength leave nothing") {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  for (const double noise : {0.01, 0.03, 0.1, 1.0}) {
    const SurfaceMesh mesh = grid(14, 14);
    Points2 uv = mesh.vertices.leftCols(2);
    for (Eigen::Index i = 0; i < uv.size(); ++i) uv.data()[i] += noise * normal(generator);
    Cut cut = cut_to_disks(mesh);
    const Cut before = cut;
    check_division(before, cut, split_overlap(cut, uv), uv);
  }
}

TEST_CASE("divide_charts refuses parts that are not counted") {
  Cut cut = cut_to_disks(grid(2, 1));
  CHECK_THROWS_WITH_AS(divide_charts(cut, {0, 0}), doctest::Contains("4 triangles"), Error);
  CHECK_THROWS_WITH_AS(divide_charts(cut, {0, 2, 0, 1}), doctest::Contains("triangle 1"), Error);
  CHECK_THROWS_WITH_AS(divide_charts(cut, {0, -1, 0, 1}), doctest::Contains("triangle 1"), Error);
}

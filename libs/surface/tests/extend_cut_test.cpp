// Cuts that are led on to a vertex.
#include "cuts.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/components.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/seams.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <cstddef>
#include <random>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;

TEST_CASE("extend cut: from a vertex to the boundary, still a disk, values carried over") {
  const SurfaceMesh mesh = icosphere(3);
  Cut cut = cut_to_disks(mesh);
  std::mt19937 random(5);
  for (int round = 0; round < 10; ++round) {
    const Cut before = cut;
    const int vertex = static_cast<int>(random() % static_cast<unsigned>(mesh.vertices.rows()));
    std::vector<int> previous;
    try {
      previous = extend_cut(cut, vertex);
    } catch (const Error& error) {
      CHECK(std::string(error.what()).find("is on the boundary already") != std::string::npos);
      continue;
    }
    is_cut_of(mesh, cut);
    require_disk(cut.mesh);
    CHECK(cut.seams.size() > before.seams.size());
    CHECK(cut.charts[0].seam_length == doctest::Approx(seam_length(mesh.vertices, cut.seams)));
    REQUIRE(previous.size() == static_cast<std::size_t>(cut.mesh.vertices.rows()));
    for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
      CHECK(previous[cut.mesh.triangles.data()[i]] == before.mesh.triangles.data()[i]);
    CHECK_THROWS_WITH_AS(extend_cut(cut, vertex), doctest::Contains("on the boundary already"), Error);
  }
}

TEST_CASE("extend cut: in the chart of the vertex only, holes stay holes") {
  const SurfaceMesh mesh = merge({disc(6), plate_with_holes()});
  Cut cut = cut_to_disks(mesh, {.holes = Holes::keep_all});
  const std::vector<Chart> before = cut.charts;
  extend_cut(cut, 127 + 25 * 11 + 12);
  is_cut_of(mesh, cut);
  CHECK(cut.charts[0].seam_length == 0);
  CHECK(cut.charts[1].seam_length > 0);
  CHECK(cut.charts[1].loops == before[1].loops);
  CHECK_THROWS_WITH_AS(extend_cut(cut, -1), doctest::Contains("vertex -1: it does not exist"), Error);
  CHECK_THROWS_WITH_AS(extend_cut(cut, 100000), doctest::Contains("does not exist"), Error);
}

TEST_CASE("extend cut: no spurs, and ends are gone on from") {
  const SurfaceMesh mesh = disc(20);
  Cut cut = cut_to_disks(mesh);
  const auto beside = [&](double x, double y) {
    Eigen::Index nearest = 0;
    (cut.mesh.vertices.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  };
  extend_cut(cut, beside(0.93, 0));  // one edge from the boundary
  CHECK(cut.seams.size() == 4);
  CHECK(cut.paths().size() == 1);
  extend_cut(cut, beside(0.6, 0.02));
  CHECK(cut.paths().size() == 1);  // goes on
  CHECK(cut.seams.size() > 5);
}

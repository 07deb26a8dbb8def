// Flip-free starts where Tutte's embedding collapses, and untangling.
#include "hard_disks.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/parameterization/start.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace isostretch;
using namespace isostretch::parameterization;
using namespace isostretch::parameterization::test;

namespace {

mesh::ElementArrays rest_of(const mesh::SurfaceMesh& chart) {
  mesh::ElementArrays rest = mesh::flat_elements(chart);
  mesh::scale_to_total_weight(rest, 1.0);
  return rest;
}

struct Flattened {
  StartResult start;
  newton::Summary summary;
};

// A flip-free start, and a minimisation from there that keeps it so.
Flattened flatten(const mesh::SurfaceMesh& chart, const StartOptions& options = {},
                  int max_iterations = 1000) {
  const mesh::ElementArrays rest = rest_of(chart);
  Flattened result;
  result.start = flip_free_start(chart, rest, options);
  CAPTURE(result.start.message);
  REQUIRE(result.start.ok());
  CHECK(mesh::count_flipped(result.start.uv, chart.triangles) == 0);
  newton::Objective objective(2, rest.node_count);
  objective.add<newton::EnergyTerm>(assembly::elements_from(rest),
                                    energies::make_energy("symmetric_dirichlet"));
  Vector x = Eigen::Map<const Vector>(result.start.uv.data(), result.start.uv.size());
  newton::Options solve;
  solve.max_iterations = max_iterations;
  result.summary = newton::minimize(objective, x, solve);
  const mesh::Points2 uv = Eigen::Map<const mesh::Points2>(x.data(), chart.vertices.rows(), 2);
  CHECK(mesh::count_flipped(uv, chart.triangles) == 0);
  return result;
}

// Nodes moved at random by up to `most`, except where pinned.
template <class Pinned>
Vector shaken(const Vector& x, int dim, double most, const Pinned& pinned) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> shift(-most, most);
  Vector y = x;
  for (Eigen::Index i = 0; i < y.size(); ++i)
    if (!pinned(static_cast<int>(i) / dim)) y[i] += shift(generator);
  return y;
}

}  // namespace

TEST_CASE("ordinary charts start from Tutte's embedding as it is") {
  const Flattened face = flatten(mesh::procedural_face(12));
  CHECK(face.start.method == StartMethod::uniform);
  CHECK(face.start.reweightings == 0);
  CHECK(face.summary.converged());
}

TEST_CASE("areas from 1 to 1e-12: the flat sheet comes out flat") {
  const Flattened sheet = flatten(graded(40));
  CHECK(sheet.summary.converged());
  CHECK(sheet.summary.energy == doctest::Approx(4).epsilon(1e-6));
}

TEST_CASE("needles: weights that know their shape, and a stretch of the whole") {
  const Flattened mild = flatten(needles(16, 1e-4));
  CHECK(mild.summary.converged());
  CHECK(mild.summary.energy == doctest::Approx(4).epsilon(1e-3));
  // At a hundred million to one the minimisation crawls, but nothing turns over.
  const Flattened extreme = flatten(needles(16, 1e-8), {}, 100);
  CHECK(extreme.summary.energy < extreme.summary.initial_energy);
}

TEST_CASE("flat needles are laid down as they are") {
  mesh::SurfaceMesh needle;
  needle.vertices.resize(3, 3);
  needle.vertices << 1, 2, 3, 2, 2, 3, 1.5, 2, 3 + 1e-12;
  needle.triangles.resize(1, 3);
  needle.triangles << 0, 1, 2;
  const Flattened one = flatten(needle);
  CHECK(one.summary.converged());
  CHECK(one.summary.energy == doctest::Approx(4).epsilon(1e-9));
}

TEST_CASE("a corridor along a Hilbert curve") {
  const Flattened corridor = flatten(hilbert_corridor(8));
  CHECK(corridor.summary.converged());
  CHECK(corridor.summary.energy == doctest::Approx(4).epsilon(1e-6));
}

TEST_CASE("a finger whose end uniform weights make tiny is reweighted") {
  const Flattened tapered = flatten(finger(16, 40));
  CHECK(tapered.start.method == StartMethod::weighted);
  CHECK(tapered.start.reweightings > 0);
  CHECK(tapered.summary.converged());
}

TEST_CASE("a finger whose end is lost to rounding altogether is untangled") {
  const Flattened longest = flatten(finger(8, 400));
  CHECK(longest.start.method == StartMethod::untangled);
  CHECK(longest.summary.converged());
}

TEST_CASE("a chart with a hole starts and stays with it") {
  mesh::SurfaceMesh ring = mesh::disc(8);
  std::vector<int> kept;
  for (Eigen::Index t = 0; t < ring.triangles.rows(); ++t)
    if (!(ring.triangles.row(t).array() == 0).any()) kept.push_back(static_cast<int>(t));
  // The vertex in the middle goes with its triangles: a chart has no vertex of no triangle.
  const mesh::Triangles all = ring.triangles;
  ring.triangles.resize(std::ssize(kept), 3);
  for (std::size_t t = 0; t < kept.size(); ++t)
    ring.triangles.row(static_cast<Eigen::Index>(t)) = all.row(kept[t]).array() - 1;
  ring.vertices = mesh::Points3(ring.vertices.bottomRows(ring.vertices.rows() - 1));
  const Flattened result = flatten(ring);
  CHECK(result.summary.converged());
  CHECK(result.summary.energy == doctest::Approx(4).epsilon(1e-6));
}

TEST_CASE("untangling: a shaken square with its boundary pinned") {
  const mesh::SurfaceMesh grid = mesh::grid(12, 12);
  const mesh::ElementArrays rest = rest_of(grid);
  mesh::Points2 uv = grid.vertices.leftCols<2>();
  std::vector<int> boundary;
  for (int v = 0; v < uv.rows(); ++v)
    if (uv.row(v).minCoeff() == 0 || uv.row(v).maxCoeff() == uv.maxCoeff()) boundary.push_back(v);
  const auto pinned = [&](int v) { return std::find(boundary.begin(), boundary.end(), v) != boundary.end(); };
  const Vector flat = Eigen::Map<const Vector>(uv.data(), uv.size());
  Vector x = shaken(flat, 2, 3.0 / 12 * uv.maxCoeff(), pinned);
  const auto flipped = [&] {
    return mesh::count_flipped(Eigen::Map<const mesh::Points2>(x.data(), uv.rows(), 2), grid.triangles);
  };
  CHECK(flipped() > 50);
  const UntangleResult result = untangle(assembly::elements_from(rest), x, {}, boundary);
  CHECK(result.untangled);
  CHECK(result.smallest_determinant > 0);
  CHECK(flipped() == 0);
  for (const int v : boundary) CHECK(x.segment<2>(2 * v) == flat.segment<2>(2 * v));
}

TEST_CASE("untangling: shaken tetrahedra") {
  const mesh::TetMesh bar = mesh::tet_bar(3, 3, 8);
  const assembly::Elements elements = assembly::elements_from(mesh::elements(bar));
  const Vector rest = Eigen::Map<const Vector>(bar.vertices.data(), bar.vertices.size());
  const double cell = std::cbrt(mesh::total_weight(mesh::elements(bar)) / 72);
  Vector x = shaken(rest, 3, 0.4 * cell, [](int) { return false; });
  const UntangleResult result = untangle(elements, x);
  CHECK(result.untangled);
  CHECK(result.iterations > 0);
}

TEST_CASE("what cannot be untangled is said, and stopping is obeyed") {
  // Two triangles that share all three pinned corners in opposite order.
  mesh::SurfaceMesh pair = mesh::grid(1, 1);
  const assembly::Elements elements = assembly::elements_from(mesh::flat_elements(pair));
  Vector x(8);
  x << 0, 0, 1, 0, 0, 1, -0.2, -0.2;
  const UntangleResult stuck = untangle(elements, x, {}, {0, 1, 2, 3});
  CHECK(!stuck.untangled);
  CHECK(stuck.worst_element >= 0);
  Vector y = x;
  const StopSource source;
  source.request_stop();
  UntangleOptions told_to_stop;
  told_to_stop.stop = source.token();
  const UntangleResult stopped = untangle(elements, y, told_to_stop, {0, 1, 2});
  CHECK((stopped.stopped || stopped.untangled));
  CHECK(stopped.rounds <= 1);
  Vector bad = x;
  bad[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(untangle(elements, bad), "untangle: the start must be 8 finite numbers", Error);
}

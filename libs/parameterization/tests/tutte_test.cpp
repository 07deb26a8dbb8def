#include "conditional.hpp"
#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/parameterization/tutte.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/check.hpp>
#include <isostretch/surface/cut.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::parameterization;
using namespace isostretch::mesh::test;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

void check_embedding(const SurfaceMesh& mesh, const TutteOptions& options = {}) {
  const TutteResult result = tutte_embedding(mesh, options);
  CHECK_MESSAGE(result.status == TutteStatus::ok, result.message);
  CHECK(result.message.empty());
  const OrientationReport report = orientation(result.uv, mesh.triangles);
  CHECK(report.flipped.empty());
  CHECK(report.smallest_area > 0);
  CHECK(report.total_area == doctest::Approx(1).epsilon(1e-12));
  const std::vector<int> loop = boundary_loops(mesh).front();
  const double radius = result.uv.row(loop[0]).norm();
  for (const int v : loop) CHECK(result.uv.row(v).norm() == doctest::Approx(radius).epsilon(1e-12));
}

}  // namespace

TEST_CASE("Tutte: generated disks have no flips and area 1") {
  check_embedding(grid(1, 1));  // no interior vertex
  check_embedding(grid(13, 5));
  check_embedding(grid(20, 1, 100, 1));
  check_embedding(disc(1));
  check_embedding(disc(25));
  check_embedding(procedural_face(30));
  check_embedding(surface({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}));
}

TEST_CASE("Tutte: every solver gives the same embedding") {
  const SurfaceMesh mesh = procedural_face(12);
  const Points2 reference = tutte_embedding(mesh).uv;
  for (const sparse::Backend backend : sparse::available_backends()) {
    TutteOptions options;
    options.solver.backend = backend;
    options.solver.pcg_tolerance = 1e-13;
    check_embedding(mesh, options);
    CHECK((tutte_embedding(mesh, options).uv - reference).cwiseAbs().maxCoeff() < 1e-10);
  }
}

TEST_CASE("Tutte: boundary spacing follows edge lengths, interior vertices are means") {
  const SurfaceMesh mesh = grid(2, 2, 3, 1);
  const Points2 uv = tutte_embedding(mesh).uv;
  // Vertex 4 is the middle one; its neighbours: 0, 1, 3, 5, 7, 8.
  const Eigen::RowVectorXd mean = (uv.row(0) + uv.row(1) + uv.row(3) + uv.row(5) + uv.row(7) + uv.row(8)) / 6;
  CHECK((uv.row(4) - mean).norm() < 1e-15);
  const auto angle = [&](int i, int j) {
    return std::acos(uv.row(i).normalized().dot(uv.row(j).normalized()));
  };
  CHECK(angle(0, 1) / angle(2, 5) == doctest::Approx(3.0));
}

TEST_CASE("Tutte: coinciding boundary vertices are still told apart") {
  SurfaceMesh mesh = disc(4);
  const std::vector<int> loop = boundary_loops(mesh).front();
  mesh.vertices.row(loop[3]) = mesh.vertices.row(loop[2]);
  check_embedding(mesh);
  mesh.vertices.setZero();
  check_embedding(mesh);
}

TEST_CASE("Tutte: triangles too small for floating point are listed, not passed over") {
  // Triangles nested in triangles: each ring is a fixed fraction of the one around it.
  const int rings = 150;
  SurfaceMesh mesh;
  mesh.vertices.resize(3 * rings, 3);
  for (int v = 0; v < 3 * rings; ++v) {
    const double angle = 2.0943951023931953 * (v % 3), radius = rings - v / 3;
    mesh.vertices.row(v) << radius * std::cos(angle), radius * std::sin(angle), 0;
  }
  mesh.triangles.resize(6 * (rings - 1) + 1, 3);
  int t = 0;
  for (int r = 0; r + 1 < rings; ++r)
    for (int i = 0; i < 3; ++i) {
      const int o = 3 * r + i, next_o = 3 * r + (i + 1) % 3;
      mesh.triangles.row(t++) << o, next_o, o + 3;
      mesh.triangles.row(t++) << o + 3, next_o, next_o + 3;
    }
  mesh.triangles.row(t) << 3 * rings - 3, 3 * rings - 2, 3 * rings - 1;
  const TutteResult result = tutte_embedding(mesh);
  CHECK(result.status == TutteStatus::flipped);
  CHECK(result.flipped.size() > 0);
  CHECK(result.flipped == orientation(result.uv, mesh.triangles).flipped);
  CHECK(result.message.find("triangles are not positively oriented, first triangle") != std::string::npos);
  CHECK(result.uv.rows() == mesh.vertices.rows());
}

TEST_CASE("Tutte: what is not a disk is refused with the reason") {
  CHECK_THROWS_WITH_AS(tutte_embedding(icosphere(1)), doctest::Contains("no boundary"), Error);
  CHECK_THROWS_WITH_AS(tutte_embedding(without(torus(8, 6), {3})), doctest::Contains("genus 1"), Error);
  SurfaceMesh mesh = square();
  mesh.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(tutte_embedding(mesh),
                       doctest::Contains("vertex 0 has a coordinate that is not finite"), Error);
}

TEST_CASE("Tutte: a solver that does not converge is a status") {
  TutteOptions options;
  options.solver.backend = sparse::Backend::pcg;
  options.solver.pcg_max_iterations = 2;
  const TutteResult result = tutte_embedding(disc(20), options);
  CHECK(result.status == TutteStatus::failed);
  CHECK(result.message.find("iteration limit") != std::string::npos);
  CHECK(result.uv.rows() == 0);
}

TEST_CASE("Tutte: scanned disks have no flips and area 1" * outside_data({"meshes/disks"})) {
  for (const char* name : {"armadillocut_62k.obj", "bunnycut_19k.obj", "camelb_up1_14k.obj",
                           "camelhead_23k.obj", "face_52k.obj", "lilium_6k.obj"}) {
    CAPTURE(name);
    const SurfaceMesh mesh = read_surface(outside_path("meshes/disks/" + std::string(name)));
    CHECK(check(mesh).count(DefectKind::zero_size) == 0);
    flat_elements(mesh);
    check_embedding(mesh);
  }
}

TEST_CASE("spheres that were cut open embed, the smallest too") {
  for (const SurfaceMesh& sphere : {tetrahedron(), icosphere(0), icosphere(1), icosphere(3)})
    check_embedding(cut_to_disks(sphere).mesh);
}

TEST_CASE("on a square: sides straight to the bit, corners where they are asked for") {
  const SurfaceMesh mesh = disc(4);
  const std::vector<int> loop = boundary_loops(mesh).front();
  const auto n = static_cast<int>(loop.size());
  TutteOptions options;
  options.boundary = BoundaryShape::square;
  SUBCASE("chosen") {}
  SUBCASE("given") {
    for (const int i : {1, n / 3, n / 2, n - 2}) options.corners.push_back(loop[static_cast<std::size_t>(i)]);
  }
  const TutteResult result = tutte_embedding(mesh, options);
  REQUIRE(result.status == TutteStatus::ok);
  int corners = 0;
  for (const int v : loop) {
    const bool left_right = std::abs(result.uv(v, 0)) == 0.5, up_down = std::abs(result.uv(v, 1)) == 0.5;
    CHECK((left_right || up_down));
    corners += left_right && up_down;
  }
  CHECK(corners == 4);
  if (!options.corners.empty()) CHECK(result.uv.row(options.corners[0]) == Eigen::RowVector2d(-0.5, -0.5));
  CHECK(orientation(result.uv, mesh.triangles).total_area == doctest::Approx(1));
}

TEST_CASE("corners that make no square are refused") {
  const SurfaceMesh mesh = disc(4);
  const std::vector<int> loop = boundary_loops(mesh).front();
  const auto embed = [&](std::vector<int> corners) {
    TutteOptions options;
    options.boundary = BoundaryShape::square;
    options.corners = std::move(corners);
    tutte_embedding(mesh, options);
  };
  CHECK_THROWS_WITH_AS(embed({loop[0], loop[1]}), "2 corners given: a square has four", Error);
  CHECK_THROWS_WITH_AS(embed({0, loop[1], loop[2], loop[3]}), "corner 0 is not on the boundary", Error);
  CHECK_THROWS_WITH_AS(embed({loop[0], loop[5], loop[3], loop[7]}), doctest::Contains("comes too late"),
                       Error);
  const SurfaceMesh triangle = surface({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2});
  TutteOptions square;
  square.boundary = BoundaryShape::square;
  CHECK_THROWS_WITH_AS(tutte_embedding(triangle, square), doctest::Contains("too few for a square"), Error);
}

TEST_CASE("holes are closed by fans and nothing else changes") {
  SurfaceMesh mesh = disc(6);
  CHECK(fill_holes(mesh).triangles == mesh.triangles);
  // Without the fan around the middle: a hole of six sides.
  std::vector<int> around_middle;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    if ((mesh.triangles.row(t).array() == 0).any()) around_middle.push_back(static_cast<int>(t));
  const auto sides = std::ssize(around_middle);
  mesh.triangles = Triangles(mesh.triangles.bottomRows(mesh.triangles.rows() - sides));
  REQUIRE(around_middle.back() == sides - 1);
  REQUIRE(boundary_loops(mesh).size() == 2);
  const SurfaceMesh filled = fill_holes(mesh);
  CHECK(filled.triangles.topRows(mesh.triangles.rows()) == mesh.triangles);
  CHECK(filled.triangles.rows() == mesh.triangles.rows() + sides);
  CHECK(filled.vertices.rows() == mesh.vertices.rows() + 1);
  CHECK(boundary_loops(filled).size() == 1);
  CHECK(check(filled).count(DefectKind::inconsistent_orientation) == 0);
}

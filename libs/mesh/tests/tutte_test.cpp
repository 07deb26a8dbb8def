#include "meshes.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/boundary.hpp>
#include <isostretch/mesh/check.hpp>
#include <isostretch/mesh/cut.hpp>
#include <isostretch/mesh/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh/io.hpp>
#include <isostretch/mesh/orientation.hpp>
#include <isostretch/mesh/tutte.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
namespace fs = std::filesystem;

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

TEST_CASE("Tutte: scanned disks have no flips and area 1") {
  const fs::path folder = fs::path(ISOSTRETCH_SOURCE_DIR) / ".." / "shared" / "meshes" / "disks";
  for (const char* name : {"armadillocut_62k.obj", "bunnycut_19k.obj", "camelb_up1_14k.obj",
                           "camelhead_23k.obj", "face_52k.obj", "lilium_6k.obj"}) {
    if (!fs::exists(folder / name)) {
      MESSAGE("skipped, not there: ", name);
      continue;
    }
    CAPTURE(name);
    const SurfaceMesh mesh = read_surface((folder / name).string());
    CHECK(check(mesh).count(Kind::zero_size) == 0);
    flat_elements(mesh);
    check_embedding(mesh);
  }
}

TEST_CASE("cut: a sphere becomes a disk with one loop, and Tutte works on it") {
  for (int level = 1; level < 5; ++level) {
    SurfaceMesh sphere = icosphere(level);
    sphere.vertices.col(0) *= 3;
    const CutResult cut = cut_to_disk_simple(sphere);
    const Report report = check(cut.mesh);
    CHECK(report.clean());
    require_disk(report);
    const auto edges = cut.path.size() - 1;
    CHECK(edges >= 3);
    CHECK(boundary_loops(cut.mesh).front().size() == 2 * edges);
    CHECK(cut.mesh.vertices.rows() == sphere.vertices.rows() + static_cast<Eigen::Index>(edges) - 1);
    REQUIRE(cut.original_vertex.size() == static_cast<std::size_t>(cut.mesh.vertices.rows()));
    for (Eigen::Index t = 0; t < sphere.triangles.rows(); ++t)
      for (int c = 0; c < 3; ++c)
        CHECK(cut.original_vertex[static_cast<std::size_t>(cut.mesh.triangles(t, c))] ==
              sphere.triangles(t, c));
    for (std::size_t v = 0; v < cut.original_vertex.size(); ++v)
      CHECK(cut.mesh.vertices.row(static_cast<Eigen::Index>(v)) ==
            sphere.vertices.row(cut.original_vertex[v]));
    check_embedding(cut.mesh);
  }
}

TEST_CASE("cut: uv of the input is kept") {
  SurfaceMesh sphere = icosphere(2);
  sphere.uv = sphere.vertices.leftCols<2>();
  sphere.uv_triangles = sphere.triangles;
  const CutResult cut = cut_to_disk_simple(sphere);
  CHECK(cut.mesh.uv == sphere.uv);
  CHECK(cut.mesh.uv_triangles == sphere.triangles);
}

TEST_CASE("cut: the coarsest sphere that can be cut, by number of edges") {
  const CutResult cut = cut_to_disk_simple(icosphere(0));
  CHECK(cut.path.size() == 4);
  check_embedding(cut.mesh);
}

TEST_CASE("cut: anything but a closed surface of genus 0 is refused with the reason") {
  CHECK_THROWS_WITH_AS(cut_to_disk_simple(disc(2)), doctest::Contains("not closed, it has 1 boundary loop"),
                       Error);
  CHECK_THROWS_WITH_AS(cut_to_disk_simple(torus(6, 5)), doctest::Contains("it has genus 1"), Error);
  CHECK_THROWS_WITH_AS(cut_to_disk_simple(tetrahedron()), doctest::Contains("too coarse"), Error);
  CHECK_THROWS_WITH_AS(cut_to_disk_simple(SurfaceMesh{}), doctest::Contains("no triangles"), Error);
  SurfaceMesh two = tetrahedron();
  two.vertices.conservativeResize(8, 3);
  two.vertices.bottomRows(4) = two.vertices.topRows(4).array() + 5;
  two.triangles.conservativeResize(8, 3);
  two.triangles.bottomRows(4) = two.triangles.topRows(4).array() + 4;
  CHECK_THROWS_WITH_AS(cut_to_disk_simple(two), doctest::Contains("2 components"), Error);
}

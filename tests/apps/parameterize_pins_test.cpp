#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/boundary.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>

#include <string>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;

namespace {

struct Flattened {
  Outcome run;
  mesh::SurfaceMesh mesh;
  nlohmann::json summary;
};

// A disc of radius 2 with 4 rings: vertex 0 in the middle, the last 24 vertices on the boundary.
Flattened flatten_disc(const Scratch& scratch, std::vector<std::string> arguments) {
  mesh::SurfaceMesh disc = mesh::disc(4);
  disc.vertices *= 2;
  mesh::write_obj(scratch.path("disc.obj"), disc);
  arguments.insert(arguments.begin(), {scratch.path("disc.obj"), "-o", scratch.path("out"), "--no-picture"});
  Flattened result{parameterize(arguments), {}, {}};
  REQUIRE_MESSAGE(result.run.code == 0, result.run.err);
  result.mesh = mesh::read_obj(scratch.path("out/disc_uv.obj"));
  result.summary = read_json(scratch.path("out/summary.json"));
  CHECK(mesh::count_flipped(result.mesh.uv, result.mesh.uv_triangles) == 0);
  return result;
}

Eigen::RowVector2d uv(const Flattened& result, int vertex) {
  return result.mesh.uv.row(vertex);
}

}  // namespace

TEST_CASE("a hard pin is where it was asked to be, to the last bit") {
  const Scratch scratch;
  const auto one = flatten_disc(scratch, {"--pin", "7:0.1,-0.7"});
  CHECK(uv(one, 7) == Eigen::RowVector2d(0.1, -0.7));
  CHECK(one.summary["energy"].get<double>() == Approx(4).epsilon(1e-8));

  // Two cost nothing either where their distance is that of the flat disc.
  const double distance = (one.mesh.vertices.row(0) - one.mesh.vertices.row(50)).norm();
  const auto two = flatten_disc(scratch, {"--pin", "0:5,5", "--pin", "50:5," + std::to_string(5 + distance)});
  CHECK(uv(two, 0) == Eigen::RowVector2d(5, 5));
  CHECK(two.summary["energy"].get<double>() == Approx(4).epsilon(1e-8));
}

TEST_CASE("pins that would turn triangles over at once are reached by pulling") {
  const Scratch scratch;
  const auto result = flatten_disc(scratch, {"--pin", "0:0.9,0", "--pin", "37:2,0", "--pin", "43:0,2",
                                             "--pin", "49:-2,0", "--pin", "55:0,-2"});
  CHECK(result.run.err.find("pulling") != std::string::npos);
  CHECK(uv(result, 0) == Eigen::RowVector2d(0.9, 0));
  CHECK(uv(result, 49) == Eigen::RowVector2d(-2, 0));
  CHECK(result.summary["energy"].get<double>() > 4.01);
}

TEST_CASE("a pin without a place keeps the initial one") {
  const Scratch scratch;
  const auto free = flatten_disc(scratch, {"--initial", "tutte"});
  const auto pinned = flatten_disc(scratch, {"--pin", "0", "--pin", "40"});
  mesh::write_obj(scratch.path("disc.obj"), free.mesh);
  const Outcome run = parameterize({scratch.path("disc.obj"), "-o", scratch.path("kept"), "--no-picture",
                                    "--initial", "input", "--pin", "0", "--pin", "40", "--pin", "12"});
  CHECK_MESSAGE(run.code == 0, run.err);
  const auto kept = mesh::read_obj(scratch.path("kept/disc_uv.obj"));
  for (const int v : {0, 40, 12}) CHECK((kept.uv.row(v) - free.mesh.uv.row(v)).norm() < 1e-13);
  CHECK(pinned.summary["options"]["pins"].size() == 2);
}

TEST_CASE("a soft pin pulls the harder the more it weighs") {
  const Scratch scratch;
  // The whole disc can follow one soft pin, so the middle is held.
  const auto light = flatten_disc(scratch, {"--pin", "0:0,0", "--soft-pin", "45:3,0"});
  const auto heavy = flatten_disc(scratch, {"--pin", "0:0,0", "--soft-pin", "45:3,0:1000"});
  const Eigen::RowVector2d target(3, 0);
  CHECK((uv(heavy, 45) - target).norm() < 0.1 * (uv(light, 45) - target).norm());
  CHECK(light.summary["soft_pin_energy"].get<double>() > 0);
  const double area = 0.25 * mesh::total_area(mesh::disc(4)) * 16;
  const double expected = 1000 * (uv(heavy, 45) - target).squaredNorm() / area;
  CHECK(heavy.summary["soft_pin_energy"].get<double>() == Approx(expected).epsilon(1e-8));
}

TEST_CASE("vertices on a cut cannot be pinned") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("ball.obj"), mesh::icosphere(2));
  std::string refused;
  for (int v = 0; v < 162 && refused.empty(); ++v) {
    const Outcome run = parameterize({scratch.path("ball.obj"), "-o", scratch.path("out"), "--no-picture",
                                      "--pin", std::to_string(v), "--max-iterations", "0"});
    if (run.code == 2) refused = run.err;
  }
  CHECK(refused.find("copies in the layout") != std::string::npos);
}

TEST_CASE("what is held stays where it is, whatever else is pinned or aligned") {
  const Scratch scratch;
  const mesh::SurfaceMesh face = mesh::procedural_face(8);
  mesh::write_obj(scratch.path("face.obj"), face);
  const auto run = [&](std::vector<std::string> options) {
    options.insert(options.begin(),
                   {scratch.path("face.obj"), "-o", scratch.path("out"), "--no-picture", "--quiet"});
    const Outcome outcome = parameterize(options);
    CHECK_MESSAGE(outcome.code == 0, outcome.err);
    return mesh::read_obj(scratch.path("out/face_uv.obj"));
  };
  const std::vector<int> loop = mesh::boundary_loops(face).front();
  const mesh::SurfaceMesh circle = run({"--boundary", "circle", "--uv-units", "model", "--pack", "none"});
  const mesh::SurfaceMesh pinned = run({"--boundary", "circle", "--pin", "0:0.05,0.05"});
  const mesh::SurfaceMesh aligned =
      run({"--boundary", "circle", "--horizontal", std::to_string(loop[3]) + ",0", "--uv-units", "model",
           "--pack", "none"});
  for (const int v : loop) {
    CHECK(pinned.uv.row(v) == circle.uv.row(v));
    CHECK(aligned.uv.row(v) == circle.uv.row(v));
  }
  CHECK(pinned.uv.row(0) == Eigen::RowVector2d(0.05, 0.05));
  CHECK(aligned.uv(0, 1) == aligned.uv(loop[3], 1));

  const auto refuse = [&](std::vector<std::string> options, const std::string& words) {
    options.insert(options.begin(), {scratch.path("face.obj"), "-o", scratch.path("no")});
    const Outcome outcome = parameterize(options);
    CAPTURE(outcome.err);
    CHECK((outcome.code == 2 || outcome.code == 3));
    CHECK(outcome.err.find(words) != std::string::npos);
  };
  refuse({"--boundary", "circle", "--pin", std::to_string(loop[0]) + ":0,0"}, "boundary that is held");
  refuse({"--pack", "square", "--pin", "0:0,0"}, "pack none");
}

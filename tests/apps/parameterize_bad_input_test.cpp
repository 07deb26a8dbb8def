// What people really have: broken, truncated and strange surfaces. Each ends with a message and nothing
// written.
#include "process.hpp"
#include "scratch.hpp"

#include "meshes.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <unistd.h>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>

using namespace isostretch;
using namespace isostretch::test;

namespace {

std::string write_model(const Scratch& scratch, const std::string& name, const mesh::SurfaceMesh& model) {
  mesh::write_obj(scratch.path(name), model);
  return scratch.path(name);
}

void check_refused(const Scratch& scratch, const std::string& model, const std::string& message) {
  const auto before = scratch.contents();
  const Outcome run = parameterize({model, "-o", scratch.path("out")});
  CAPTURE(run.err);
  CHECK(run.code == 3);
  CHECK_MESSAGE(run.err.find(message) != std::string::npos, message);
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  CHECK(scratch.contents() == before);
}

}  // namespace

TEST_CASE("files with nothing in them to flatten") {
  const Scratch scratch;
  check_refused(scratch, scratch.write("empty.obj", ""), "empty.obj:1: no vertices and no faces");
  check_refused(scratch, scratch.write("points.obj", "v 0 0 0\nv 1 0 0\n"), "points.obj:2: no faces");
  check_refused(scratch, scratch.write("zero.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "no faces");
  std::filesystem::create_directory(scratch.path("folder.ply"));
  check_refused(scratch, scratch.path("folder.ply"), "folder.ply: cannot read: Is a directory");
  std::mt19937 generator(1);
  std::string garbage(4096, '\0');
  for (char& c : garbage) c = static_cast<char>(generator());
  for (const char* name : {"garbage.obj", "garbage.off", "garbage.ply", "garbage.stl", "garbage.msh",
                           "garbage.mesh", "garbage.vtk", "garbage.vtu"})
    check_refused(scratch, scratch.write(name, garbage), name);
}

TEST_CASE("numbers that are none, and indices that point nowhere") {
  const Scratch scratch;
  const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  check_refused(scratch, scratch.write("nan.obj", "v 0 nan 0\n" + good + "f 1 2 3\n"),
                "nan.obj:1: y coordinate 'nan'");
  check_refused(scratch, scratch.write("inf.obj", good + "v 0 0 -inf\nf 1 2 3\n"),
                "inf.obj:4: z coordinate '-inf'");
  check_refused(scratch, scratch.write("index.obj", good + "f 1 2 4\n"),
                "index.obj:4: vertex index 4 is out of range");
  check_refused(scratch, scratch.write("quad.obj", good + "v 1 1 0\nf 1 4 2 3\n"),
                "quad.obj:5: face 0 of 4 vertices crosses itself or has no area");
}

TEST_CASE(
    "surfaces that are no manifold are refused by element, and --repair takes what has one right answer") {
  const Scratch scratch;
  const std::string sheet = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0.5 0.5 1\nv 2 2 0\nv 2 3 0\n";
  check_refused(scratch, scratch.write("edge.obj", sheet + "f 1 2 3\nf 2 1 4\nf 1 2 5\n"), "edge 0-1");
  const auto bow = scratch.write("bow.obj", sheet + "f 1 2 3\nf 3 2 4\nf 4 6 7\n");
  check_refused(scratch, bow, "vertex 3");
  check_refused(scratch, bow, "; --repair mends that");
  CHECK(parameterize({bow, "-o", scratch.path("bow"), "--repair", "--no-picture"}).code == 0);
  const auto turned = scratch.write("turned.obj", sheet + "f 1 2 3\nf 2 3 4\n");
  check_refused(scratch, turned, "triangles 0 and 1");
  const Outcome repaired = parameterize({turned, "-o", scratch.path("turned"), "--repair", "--no-picture"});
  CHECK_MESSAGE(repaired.code == 0, repaired.err);
  CHECK(repaired.err.find("repair: ") != std::string::npos);
  CHECK(read_json(scratch.path("turned/summary.json"))["repairs"]["turned"].size() == 1);
  const auto doubled = scratch.write("doubled.obj", sheet + "f 1 2 3\nf 3 2 4\nf 2 3 1\n");
  check_refused(scratch, doubled, "triangle 2");
  CHECK(parameterize({doubled, "-o", scratch.path("doubled"), "--repair", "--no-picture"}).code == 0);
}

TEST_CASE("--check says what is wrong and writes nothing") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("torus.obj"), mesh::test::torus(12, 9));
  const Outcome good = parameterize({scratch.path("torus.obj"), "--check"});
  CHECK(good.code == 0);
  CHECK_MESSAGE(good.out.find("genus 1") != std::string::npos, good.out);
  const auto bad = scratch.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n");
  const Outcome said = parameterize({bad, "--check"});
  CHECK(said.code == 3);
  CHECK_MESSAGE(said.out.find("triangles 0 and 1") != std::string::npos, said.out);
  CHECK(parameterize({bad, "--check", "--repair"}).code == 0);
  CHECK(scratch.contents().size() == 2);
}

TEST_CASE("one-sided surfaces are refused, also with --repair") {
  const Scratch scratch;
  for (const bool closed : {false, true}) {
    const auto model = write_model(scratch, closed ? "klein.obj" : "moebius.obj",
                                   mesh::test::glued_strip(closed ? 12 : 20, closed ? 8 : 3, true, closed));
    check_refused(scratch, model, "orient");
    const Outcome run = parameterize({model, "-o", scratch.path("out"), "--repair"});
    CHECK(run.code == 3);
    CHECK(run.err.find("orient") != std::string::npos);
    CHECK(!std::filesystem::exists(scratch.path("out")));
  }
}

TEST_CASE("a triangle without area among good ones is named") {
  const Scratch scratch;
  mesh::SurfaceMesh disc = mesh::disc(4);
  // A vertex moved onto the middle of the opposite edge.
  const Eigen::Index t = 7;
  disc.vertices.row(disc.triangles(t, 0)) =
      0.5 * (disc.vertices.row(disc.triangles(t, 1)) + disc.vertices.row(disc.triangles(t, 2)));
  check_refused(scratch, write_model(scratch, "flat.obj", disc), "flat.obj: triangle 7");
}

TEST_CASE("the smallest surfaces are flattened") {
  const Scratch scratch;
  const auto one = scratch.write("one.obj", "v 0 0 0\nv 3 0 0\nv 0 4 5\nf 1 2 3\n");
  const Outcome run = parameterize({one, "-o", scratch.path("one"), "--no-picture"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(read_json(scratch.path("one/summary.json"))["energy"].get<double>() == doctest::Approx(4));
  const auto two =
      scratch.write("two.obj", "v 0 0 0\nv 3 0 0\nv 0 4 5\nv 9 0 0\nv 9 1 0\nv 9 0 1\nf 1 2 3\nf 4 5 6\n");
  CHECK(parameterize({two, "-o", scratch.path("two"), "--no-picture"}).code == 0);
  CHECK(read_json(scratch.path("two/summary.json"))["layout"]["charts"] == 2);
  const auto tetrahedron = write_model(scratch, "tetrahedron.obj", mesh::test::tetrahedron());
  CHECK(parameterize({tetrahedron, "-o", scratch.path("tet"), "--no-picture"}).code == 0);
}

TEST_CASE("a file cut off at every percent of its length gives a message or a result, and no half of one") {
  const Scratch scratch;
  mesh::SurfaceMesh disc = mesh::disc(3);
  disc.vertices.col(2) = disc.vertices.col(0).array().square().matrix();
  for (const char* name : {"cut.obj", "cut.off", "cut.ply", "cut.msh", "cut.vtu"}) {
    mesh::write_surface(scratch.path(name), disc);
    const std::string whole = read_file(scratch.path(name));
    for (std::size_t percent = 0; percent < 100; percent += 7) {
      CAPTURE(name);
      CAPTURE(percent);
      scratch.write(name, whole.substr(0, whole.size() * percent / 100));
      const Outcome run =
          parameterize({scratch.path(name), "-o", scratch.path("out"), "--no-picture", "--quiet"});
      CAPTURE(run.err);
      CHECK((run.code == 0 || run.code == 3));
      CHECK(std::filesystem::exists(scratch.path("out/summary.json")) == (run.code == 0));
      std::filesystem::remove_all(scratch.path("out"));
    }
  }
}

TEST_CASE("a file that another process truncates meanwhile") {
  const Scratch scratch;
  const std::string model = write_model(scratch, "shrinking.obj", mesh::disc(200));
  const Outcome run =
      parameterize({model, "-o", scratch.path("out"), "--no-picture", "--max-iterations", "0"},
                   [&](int) { std::filesystem::resize_file(model, 1000); });
  CAPTURE(run.err);
  CHECK((run.code == 3 || run.code == 5));  // seen short, or read before
  if (run.code == 3) {
    CHECK(run.err.find("shrinking.obj:") != std::string::npos);
    CHECK(!std::filesystem::exists(scratch.path("out")));
  }
}

TEST_CASE("a full disk is exit code 4 and leaves nothing") {
  const Scratch scratch;
  const std::string model = write_model(scratch, "face.obj", mesh::procedural_face(12));
  // A limit on the size of files makes writes fail as a full disk does.
  const Outcome full = run({"/usr/bin/env", "--ignore-signal=XFSZ", "prlimit", "--fsize=4096",
                            program("parameterize"), model, "-o", scratch.path("out")});
  CAPTURE(full.err);
  CHECK(full.code == 4);
  CHECK(full.err.find("out/") != std::string::npos);
  CHECK(!std::filesystem::exists(scratch.path("out")));
}

TEST_CASE("a folder that cannot be written to is exit code 4") {
  if (::geteuid() == 0) {
    MESSAGE("skipped: root may write everywhere; /proc stands in for a read-only place");
    const Scratch scratch;
    const Outcome run =
        parameterize({write_model(scratch, "disc.obj", mesh::disc(3)), "-o", "/proc/isostretch"});
    CHECK(run.code == 4);
    return;
  }
  const Scratch scratch;
  std::filesystem::create_directory(scratch.path("closed"));
  std::filesystem::permissions(scratch.path("closed"), std::filesystem::perms::owner_read);
  const Outcome run =
      parameterize({write_model(scratch, "disc.obj", mesh::disc(3)), "-o", scratch.path("closed/out")});
  CHECK(run.code == 4);
  std::filesystem::permissions(scratch.path("closed"), std::filesystem::perms::owner_all);
}

TEST_CASE("the second interrupt ends the program at once, with nothing written") {
  const Scratch scratch;
  const std::string model = write_model(scratch, "face.obj", mesh::procedural_face(220));
  const std::string out = scratch.path("out");
  const Outcome run = parameterize({model, "-o", out, "--projection", "clamp"}, [&](int process) {
    for (int i = 0; i < 20000 && !std::filesystem::exists(out); ++i)
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    // Two that come before the first is handled count as one: go on until one ends it (later ones meet
    // nobody).
    for (int i = 0; i < 300; ++i) {
      ::kill(process, SIGINT);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  CHECK(run.code == -SIGINT);
  for (const std::string& name : scratch.contents()) {
    CAPTURE(name);
    CHECK(name.find("out/face_uv.obj") == std::string::npos);
    CHECK(name.find("summary") == std::string::npos);
  }
}

TEST_CASE("a time limit ends the solve with the best state") {
  const Scratch scratch;
  const std::string model = write_model(scratch, "face.obj", mesh::procedural_face(100));
  const Outcome run = parameterize(
      {model, "-o", scratch.path("out"), "--no-picture", "--projection", "clamp", "--time-limit", "0.05"});
  CHECK(run.code == 5);
  CHECK(run.err.find("limit of time") != std::string::npos);
  CHECK(read_json(scratch.path("out/summary.json"))["flipped"] == 0);
}

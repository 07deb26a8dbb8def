// How runs of isostretch-deform on usable input end: exit codes, warnings, and what is printed.
#include "deform_app.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

using namespace isostretch;
using namespace isostretch::test;
using Json = nlohmann::ordered_json;

TEST_CASE("deform: an energy that overflows is not called an inversion") {
  const Scratch scratch;
  Json scene = pulled_bar({1e160, 0, 0});
  scene["energy"] = "arap";
  scene["initial_guess"] = "previous";
  const Outcome run = deform({write_scene(scratch, scene), "-o", scratch.path("out"), "--no-picture"});
  CAPTURE(run.err);
  CHECK(run.code == 6);
  CHECK(run.err.find("frame 1: the energy is not finite") != std::string::npos);
  CHECK(run.err.find("tet ") != std::string::npos);
}

TEST_CASE("deform: where one way to spread a guess fails the next takes its place, with a warning") {
  const Scratch scratch;
  Json scene = pulled_bar({1e307, 0, 0});  // the biharmonic system overflows, the harmonic one does not
  scene["mesh"]["bar"]["size"] = {4e-3, 1e-3, 1e-3};
  const Outcome run = deform({write_scene(scratch, scene), "-o", scratch.path("out"), "--no-picture"});
  CAPTURE(run.err);
  CHECK(run.code == 6);
  const auto warnings = read_json(scratch.path("out/summary.json"))["warnings"];
  CAPTURE(warnings.dump());
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].get<std::string>().find("biharmonic failed (") != std::string::npos);
  CHECK(warnings[0].get<std::string>().find("harmonic takes its place") != std::string::npos);
}

TEST_CASE("deform: tets that are all numbered the other way round are turned, and said so") {
  const Scratch scratch;
  mesh::TetMesh bar = mesh::tet_bar(2, 1, 1);
  bar.tets.col(0).swap(bar.tets.col(1));
  mesh::write_tets(scratch.path("bar.mesh"), bar);
  const Outcome run = deform({scratch.path("bar.mesh"), "--handle", "slab:x,min,0.1", "--frames", "1", "-o",
                              scratch.path("out"), "--no-picture"});
  CHECK(run.code == 0);
  CHECK(run.err.find("turned") != std::string::npos);
}

TEST_CASE("deform: components without a handle are warned of and stay") {
  const Scratch scratch;
  const mesh::TetMesh one = mesh::tet_bar(1, 1, 1);
  mesh::TetMesh two;
  two.vertices.resize(16, 3);
  two.vertices << one.vertices, one.vertices.array() + 3;
  two.tets.resize(12, 4);
  two.tets << one.tets, one.tets.array() + 8;
  mesh::write_tets(scratch.path("two.mesh"), two);
  const Outcome run = deform({scratch.path("two.mesh"), "--handle", "vertices:0,1,2;translate=0,0,1",
                              "--frames", "1", "--format", "msh", "-o", scratch.path("out")});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(run.err.find("no handle") != std::string::npos);
  CHECK(run.err.find("vertex 8") != std::string::npos);
  const mesh::Points3 last = mesh::read_tets(scratch.path("out/frame_0001.msh")).vertices;
  CHECK((last - two.vertices).bottomRows(8).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("deform: frames that do not converge are exit code 5, the sequence goes on") {
  const Scratch scratch;
  const Outcome run = deform({write_scene(scratch, twisted_bar(60, 2)), "-o", scratch.path("out"),
                              "--max-iterations", "1", "--no-picture"});
  CHECK(run.code == 5);
  CHECK(run.err.find("2 frame(s) did not converge") != std::string::npos);
  CHECK(read_json(scratch.path("out/summary.json"))["frames"].size() == 3);
}

TEST_CASE("deform: the time limit ends the run with exit code 5, and --restart goes on") {
  const Scratch scratch;
  const std::string scene = write_scene(scratch, twisted_bar(60, 2)), out = scratch.path("out");
  const Outcome run = deform({scene, "-o", out, "--time-limit", "1e-6", "--no-picture"});
  CHECK(run.code == 5);
  CHECK(run.err.find("frame 1") != std::string::npos);
  CHECK(read_json(out + "/summary.json")["frames"][1]["reached"] == false);
  CHECK(deform({scene, "-o", out, "--restart", "--no-picture"}).code == 0);
}

TEST_CASE("deform: inverted elements are exit code 6, with frame and element") {
  const Scratch scratch;
  Json scene = twisted_bar(0, 1);
  scene["energy"] = "arap";
  scene["handles"][1]["translate"] = {-6, 0, 0};  // through the other end
  const Outcome run = deform({write_scene(scratch, scene), "-o", scratch.path("out")});
  CHECK(run.code == 6);
  CHECK(run.err.find("frame 1 has") != std::string::npos);
  CHECK(run.err.find("tet ") != std::string::npos);
  CHECK(read_json(scratch.path("out/summary.json"))["inverted"].get<int>() > 0);
  CHECK(std::filesystem::exists(scratch.path("out/deform.png")));
}

TEST_CASE("deform: a motion that no flip-free shape can follow ends with exit code 6, named") {
  const Scratch scratch;
  Json scene = twisted_bar(0, 2);
  scene["mesh"]["bar"]["cells"] = {2, 1, 1};
  scene["handles"] = {
      {{"name", "all"}, {"select", {{"slab", {{"axis", "x"}, {"end", "min"}, {"fraction", 0.6}}}}}},
      {{"name", "end"},
       {"select", {{"slab", {{"axis", "x"}, {"end", "max"}, {"fraction", 0.1}}}}},
       {"translate", {-3, 0, 0}}}};
  const Outcome run = deform({write_scene(scratch, scene), "-o", scratch.path("out"), "--no-picture"});
  CHECK(run.code == 6);
  CHECK(run.err.find("frame 2") != std::string::npos);
  CHECK(run.err.find("tet ") != std::string::npos);
  const auto summary = read_json(scratch.path("out/summary.json"));
  CHECK(summary["outcome"] == "failed");
  CHECK(std::filesystem::exists(scratch.path("out/frame_0001.vtu")));
}

TEST_CASE("deform: quiet prints nothing; help, version and energies need no input") {
  const Scratch scratch;
  const Outcome quiet =
      deform({write_scene(scratch, twisted_bar(10, 1)), "-o", scratch.path("out"), "--quiet"});
  CHECK(quiet.code == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
  const Outcome help = deform({"--help"}), list = deform({"--list-energies"}),
                version = deform({"--version"});
  CHECK(help.out.find("Exit codes:") != std::string::npos);
  CHECK(help.out.find("slab:AXIS") != std::string::npos);
  CHECK(list.out.find("mooney_rivlin_3d") != std::string::npos);
  CHECK(version.out.rfind("isostretch ", 0) == 0);
}

#include "failure.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;

namespace {

void check_failure(const Scratch& scratch, const std::vector<std::string>& arguments, int code,
                   const std::vector<std::string>& words) {
  check_failure_of([](const auto& list) { return parameterize(list); }, scratch, arguments, code, words);
}

std::string write_disc(const Scratch& scratch) {
  mesh::write_obj(scratch.path("disc.obj"), mesh::disc(4));
  return scratch.path("disc.obj");
}

}  // namespace

TEST_CASE("input that cannot be read or used is exit code 3") {
  const Scratch scratch;
  const std::string out = scratch.path("out/deep");
  SUBCASE("missing") {
    check_failure(scratch, {scratch.path("no.obj"), "-o", out}, 3, {"no.obj"});
  }
  SUBCASE("directory") {
    std::filesystem::create_directory(scratch.path("folder.obj"));
    check_failure(scratch, {scratch.path("folder.obj"), "-o", out}, 3, {"folder.obj"});
  }
  SUBCASE("garbage") {
    const auto garbage = scratch.write("garbage.obj", "v 0 0 0\nv 1 0 zebra\n");
    check_failure(scratch, {garbage, "-o", out}, 3, {"garbage.obj:2", "zebra"});
  }
  SUBCASE("empty") {
    check_failure(scratch, {scratch.write("empty.obj", ""), "-o", out}, 3, {"empty.obj"});
  }
  SUBCASE("unknown extension") {
    check_failure(scratch, {scratch.write("mesh.stl", "solid\n"), "-o", out}, 3, {"mesh.stl"});
  }
  SUBCASE("closed surface when cutting is forbidden") {
    mesh::write_obj(scratch.path("ball.obj"), mesh::icosphere(1));
    check_failure(scratch, {scratch.path("ball.obj"), "-o", out, "--no-cut"}, 3, {"ball.obj", "closed"});
  }
  SUBCASE("a triangle without area") {
    const auto flat = scratch.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\nf 1 3 2\n");
    check_failure(scratch, {flat, "-o", out}, 3, {"flat.obj", "triangle 1"});
  }
  SUBCASE("no texture coordinates to start from") {
    check_failure(scratch, {write_disc(scratch), "-o", out, "--initial", "input"}, 3,
                  {"disc.obj", "texture coordinates"});
  }
  SUBCASE("a start with a flip under a barrier") {
    const auto start =
        scratch.write("start.obj",
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.2 0.2\n"
                      "f 1/1 2/2 3/3\nf 2/2 4/4 3/3\n");
    check_failure(scratch, {start, "-o", out, "--initial", "input"}, 3,
                  {"start.obj", "triangle(s) 1", "symmetric_dirichlet"});
  }
}

TEST_CASE("wrong command lines are exit code 2") {
  const Scratch scratch;
  const std::string model = write_disc(scratch), out = scratch.path("out");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--energy", "no_such"}, "symmetric_dirichlet"},
      {{"--energy", "mips_3d"}, "does not exist in 2D"},
      {{"--param", "weight"}, "name=value"},
      {{"--param", "weight=1e400"}, "finite"},
      {{"--param", "height=1"}, "height"},
      {{"--param", "weight=1,weight=2"}, "twice"},
      {{"--gradient-tolerance", "small"}, "small"},
      {{"--gradient-tolerance", "nan"}, "nan"},
      {{"--gradient-tolerance", "-1"}, "-1"},
      {{"--max-iterations", "-1"}, "-1"},
      {{"--max-iterations", "2.5"}, "2.5"},
      {{"--time-limit", "1e999"}, "1e999"},
      {{"--threads", "0"}, "0"},
      {{"--projection", "sharp"}, "sharp"},
      {{"--backend", "abacus"}, "abacus"},
      {{"--ordering", "random"}, "random"},
      {{"--initial", "chaos"}, "chaos"},
      {{"--pin", "x"}, "vertex number"},
      {{"--pin", "1:2"}, "U,V"},
      {{"--pin", "1:2,inf"}, "inf"},
      {{"--pin", "1", "--pin", "1:0,0"}, "twice"},
      {{"--pin", "100000"}, "100000"},
      {{"--soft-pin", "1"}, "VERTEX:U,V"},
      {{"--soft-pin", "1:0,0:-1"}, "weight"},
      {{"--pin", "1", "--soft-pin", "1:0,0"}, "hard as well"},
      {{"--quiet", "--verbose"}, "--verbose"},
      {{"--no-such-option"}, "--no-such-option"},
  };
  for (const auto& [arguments, word] : wrong) {
    std::vector<std::string> command = {model, "-o", out};
    command.insert(command.end(), arguments.begin(), arguments.end());
    check_failure(scratch, command, 2, {word});
  }
  check_failure(scratch, {"-o", out}, 2, {"model"});
  check_failure(scratch, {model}, 2, {"--out"});
}

TEST_CASE("output that cannot be written is exit code 4") {
  const Scratch scratch;
  const std::string model = write_disc(scratch), file = scratch.write("file", "in the way");
  check_failure(scratch, {model, "-o", file + "/below"}, 4, {"below"});
  check_failure(scratch, {model, "-o", file}, 4, {"not a folder"});
  SUBCASE("a result's name is taken by a folder") {
    std::filesystem::create_directories(scratch.path("out/trace.csv"));
    check_failure(scratch, {model, "-o", scratch.path("out")}, 4, {"trace.csv"});
  }
}

TEST_CASE("the iteration limit is exit code 5, with the state reached") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("face.obj"), mesh::procedural_face(8));
  const Outcome run =
      parameterize({scratch.path("face.obj"), "-o", scratch.path("out"), "--max-iterations", "1"});
  CHECK(run.code == 5);
  CHECK(run.err.find("limit of iterations") != std::string::npos);
  const auto summary = read_json(scratch.path("out/summary.json"));
  CHECK(summary["status"] == "stopped_iterations");
  CHECK(summary["iterations"] == 1);
  CHECK(std::filesystem::exists(scratch.path("out/layout.png")));
  CHECK(parameterize({scratch.path("face.obj"), "-o", scratch.path("none"), "--max-iterations", "0"}).code ==
        5);
}

TEST_CASE("a result with flips is exit code 6, with the state reached") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("disc.obj"), mesh::disc(4));
  // Two neighbours that change places.
  const Outcome run = parameterize({scratch.path("disc.obj"), "-o", scratch.path("out"), "--energy", "arap",
                                    "--pin", "0:0.3,0", "--pin", "1:0,0", "--pin", "40:2,0"});
  CHECK(run.code == 6);
  CHECK(run.err.find("turned over") != std::string::npos);
  CHECK(read_json(scratch.path("out/summary.json"))["flipped"].get<int>() > 0);
}

TEST_CASE("an interrupt ends after the iteration and writes the state") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("face.obj"), mesh::procedural_face(90));
  const std::string out = scratch.path("out");
  const auto interrupt = [&](int process) {
    // The folder appears right before the solve.
    for (int i = 0; i < 20000 && !std::filesystem::exists(out); ++i)
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    ::kill(process, SIGINT);
  };
  const Outcome run =
      parameterize({scratch.path("face.obj"), "-o", out, "--no-picture", "--projection", "clamp"}, interrupt);
  CHECK_MESSAGE(run.code == 5, run.err);
  CHECK(run.err.find("interrupted") != std::string::npos);
  CHECK(read_json(out + "/summary.json")["status"] == "stopped_by_callback");
  CHECK(std::filesystem::exists(out + "/face_uv.obj"));
}

TEST_CASE("help, version and the list of energies need no model") {
  const Outcome help = parameterize({"--help"}), version = parameterize({"--version"}),
                list = parameterize({"--list-energies"});
  CHECK(help.code == 0);
  CHECK(help.out.find("Exit codes:") != std::string::npos);
  CHECK(version.code == 0);
  CHECK(version.out.rfind("isostretch ", 0) == 0);
  CHECK(list.code == 0);
  CHECK(list.out.find("symmetric_dirichlet") != std::string::npos);
  CHECK(list.out.find("mips_3d") == std::string::npos);
}

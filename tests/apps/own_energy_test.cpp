// Energies that the apps do not have: typed, and from a plug-in.
#include "deform_app.hpp"
#include "failure.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;

namespace {

struct Flattened {
  double energy = 0;
  int iterations = 0;
};

Flattened flatten(const Scratch& scratch, const std::vector<std::string>& energy) {
  const std::string mesh = scratch.path("face.obj"), out = scratch.path("out");
  mesh::write_obj(mesh, mesh::procedural_face(8));
  std::vector<std::string> arguments{mesh, "-o", out, "--no-picture"};
  arguments.insert(arguments.end(), energy.begin(), energy.end());
  const Outcome outcome = parameterize(arguments);
  CHECK_MESSAGE(outcome.code == 0, outcome.err);
  std::ifstream file(out + "/summary.json");
  const auto summary = nlohmann::json::parse(file);
  return {summary.at("energy"), summary.at("iterations")};
}

}  // namespace

TEST_SUITE("energies of one's own") {
  TEST_CASE("a typed energy flattens as the built-in one does") {
    const Scratch scratch;
    const Flattened built = flatten(scratch, {"--energy", "symmetric_dirichlet"});
    const Flattened typed = flatten(scratch, {"--energy", "w*(I2 + I2/J^2)", "--param", "w=1"});
    CHECK(typed.energy == doctest::Approx(built.energy).epsilon(1e-10));
    CHECK(typed.iterations == built.iterations);
  }

  TEST_CASE("an energy of a plug-in does so too, and its parameters can be set") {
    const Scratch scratch;
    const Flattened built = flatten(scratch, {"--energy", "symmetric_dirichlet"});
    const Flattened own = flatten(scratch, {"--plugin", test_plugin(), "--energy", "my_symmetric_dirichlet"});
    CHECK(own.energy == doctest::Approx(built.energy).epsilon(1e-10));
    CHECK(own.iterations == built.iterations);
    flatten(scratch, {"--plugin", test_plugin(), "--energy", "my_neo_hookean", "--param", "bulk=3"});
    const Flattened hencky = flatten(scratch, {"--energy", "hencky", "--param", "lambda=0"});
    const Flattened function = flatten(scratch, {"--plugin", test_plugin(), "--energy", "my_hencky"});
    CHECK(function.energy == doctest::Approx(hencky.energy).epsilon(1e-10));
    const Outcome listed = parameterize({"--plugin", test_plugin(), "--list-energies"});
    CHECK(listed.out.find("my_neo_hookean\n    bulk=1  resistance") != std::string::npos);
  }

  TEST_CASE("what is wrong with a typed energy is shown where it is") {
    const Scratch scratch;
    mesh::write_obj(scratch.path("face.obj"), mesh::procedural_face(4));
    const Outcome outcome =
        parameterize({scratch.path("face.obj"), "-o", scratch.path("out"), "--energy", "I2 + muh*J"});
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("\n  I2 + muh*J\n       ^\n") != std::string::npos);
    CHECK(outcome.err.find("'muh' is neither a variable nor a parameter") != std::string::npos);
    const Outcome solid =
        parameterize({scratch.path("face.obj"), "-o", scratch.path("out"), "--energy", "s1*s2*s3"});
    CHECK(solid.code == 2);
    CHECK(solid.err.find("does not exist in 2D") != std::string::npos);
  }

  TEST_CASE("what is no plug-in is refused") {
    const Scratch scratch;
    const auto check = [&](const std::string& file, const std::string& why) {
      const Outcome outcome = parameterize({"--plugin", file, "--list-energies"});
      CHECK(outcome.code == 2);
      CHECK_MESSAGE(outcome.err.find(why) != std::string::npos, outcome.err);
    };
    check(scratch.path("no.so"), "no.so cannot be loaded");
    check(scratch.write("text.so", "not a library\n"), "text.so cannot be loaded");
    const Outcome twice =
        parameterize({"--plugin", test_plugin(), "--plugin", test_plugin(), "--list-energies"});
    CHECK(twice.code == 2);
    CHECK(twice.err.find("there is an energy 'my_symmetric_dirichlet' already") != std::string::npos);
  }

  TEST_CASE("an energy without a minimum ends with a status that says why, and the best state is written") {
    for (const std::string energy : {"-log(J)", "-I2", "-J", "-I1", "-exp(I1)"}) {
      CAPTURE(energy);
      const Scratch scratch;
      const std::string mesh = scratch.path("face.obj"), out = scratch.path("out");
      mesh::write_obj(mesh, mesh::procedural_face(3));
      const Outcome outcome = parameterize({mesh, "-o", out, "--no-picture", "-e", energy});
      CHECK_MESSAGE(outcome.code == 6, outcome.err);
      CHECK(outcome.err.find("internal") == std::string::npos);
      CHECK(outcome.err.find("0.000000") == std::string::npos);
      const mesh::SurfaceMesh written = mesh::read_obj(out + "/face_uv.obj");
      CHECK(written.uv.allFinite());
    }
  }

  TEST_CASE("an energy that falls as triangles shrink: the layout is said to be a point, and is not split") {
    const Scratch scratch;
    const std::string mesh = scratch.path("face.obj"), out = scratch.path("out");
    mesh::write_obj(mesh, mesh::procedural_face(8));
    const Outcome outcome = parameterize({mesh, "-o", out, "--no-picture", "-e", "log(I2)"});
    CHECK_MESSAGE(
        outcome.err.find("warning: the layout has shrunk to a point: the energy falls as triangles shrink") !=
            std::string::npos,
        outcome.err);
    CHECK(outcome.err.find("please report") == std::string::npos);
    CHECK_MESSAGE(outcome.out.find("1 chart;") != std::string::npos, outcome.out);
  }

  TEST_CASE("--log-file gets what the libraries say") {
    const Scratch scratch;
    const std::string mesh = scratch.path("face.obj"), file = scratch.path("log.txt");
    mesh::write_obj(mesh, mesh::procedural_face(5));
    const Outcome outcome =
        parameterize({mesh, "-o", scratch.path("out"), "--no-picture", "--log-file", file});
    CHECK(outcome.code == 0);
    CHECK(outcome.err.find("debug") == std::string::npos);
    std::ifstream in(file);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    CHECK(text.find("debug: newton: ") != std::string::npos);
    CHECK(text.find("debug: sparse: ") != std::string::npos);
    CHECK(text.find("trace") == std::string::npos);
    const Outcome traced =
        parameterize({mesh, "-o", scratch.path("out2"), "--no-picture", "--log-level", "trace"});
    CHECK(traced.err.find("trace: newton: iteration 1: energy") != std::string::npos);
  }
}

// What isostretch-deform says of input it cannot use, and its exit codes.
#include "deform_app.hpp"
#include "failure.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;
using Json = nlohmann::ordered_json;

namespace {

void check_failure(const Scratch& scratch, const std::vector<std::string>& arguments, int code,
                   const std::vector<std::string>& words) {
  check_failure_of([](const auto& list) { return deform(list); }, scratch, arguments, code, words);
}

void check_scene(const std::function<void(Json&)>& change, const std::vector<std::string>& words) {
  const Scratch scratch;
  Json scene = twisted_bar(30, 2);
  change(scene);
  std::vector<std::string> all{"scene.json: "};
  all.insert(all.end(), words.begin(), words.end());
  check_failure(scratch, {write_scene(scratch, scene), "-o", scratch.path("out")}, 3, all);
}

}  // namespace

TEST_CASE("deform: a wrong scene is exit code 3, with the path of the key") {
  check_scene([](Json& s) { s["handels"] = 1; }, {"unknown key 'handels'", "handles"});
  check_scene([](Json& s) { s.erase("mesh"); }, {"'mesh' is missing"});
  check_scene([](Json& s) { s["mesh"] = 3; }, {"mesh: must be an object"});
  check_scene([](Json& s) { s["mesh"]["bar"]["cells"] = {4, 0, 1}; }, {"mesh.bar.cells[1]: "});
  check_scene([](Json& s) { s["mesh"]["bar"]["element"] = "prism"; }, {"mesh.bar.element: ", "hex"});
  check_scene([](Json& s) { s["mesh"]["bar"]["element"] = "quad"; }, {"mesh.bar.element: ", "2D"});
  check_scene([](Json& s) { s["order"] = 3; }, {"order: "});
  check_scene([](Json& s) { s["energy"] = "rubber"; }, {"energy: unknown energy 'rubber'", "arap"});
  check_scene([](Json& s) { s["energy"] = "mips_2d"; }, {"energy: ", "3D"});
  check_scene(
      [](Json& s) {
        s["energy"] = {{"name", "arap"}, {"parameters", {{"mu", 1}}}};
      },
      {"energy: ", "mu"});
  check_scene(
      [](Json& s) {
        s["energy"] = {{"name", "hencky"}, {"parameters", {{"mu", "a"}}}};
      },
      {"energy.parameters.mu: "});
  check_scene(
      [](Json& s) {
        s["material"] = {{"young", 1}, {"poisson", 0.3}};
      },
      {"material: ", "symmetric_dirichlet", "neo_hookean_log"});
  check_scene(
      [](Json& s) {
        s["energy"] = "hencky";
        s["material"] = {{"young", 1}, {"poisson", 0.5}};
      },
      {"material: poisson"});
  check_scene(
      [](Json& s) {
        s["energy"] = "hencky";
        s["material"] = {{"young", 1}, {"lambda", 0.5}};
      },
      {"material: give"});
  check_scene(
      [](Json& s) {
        s["regions"] = {{{"elements", {99999}}, {"energy", "arap"}}};
      },
      {"regions[0].elements: ", "99999"});
  check_scene([](Json& s) { s["regions"] = {{{"select", "all"}}}; }, {"regions[0]: "});
  check_scene([](Json& s) { s["handles"][1]["select"]["slab"]["axis"] = "w"; },
              {"handles[1].select.slab.axis: "});
  check_scene(
      [](Json& s) {
        s["handles"][1]["select"] = {{"sphere", {{"center", {9, 9, 9}}, {"radius", 1}}}};
      },
      {"handles[1].select: selects no vertex"});
  check_scene(
      [](Json& s) {
        s["handles"][1]["select"] = {{"vertices", {1, 500}}};
      },
      {"handles[1].select: ", "500"});
  check_scene([](Json& s) { s["handles"][1]["rotate"]["axis"] = {0, 0, 0}; }, {"handles[1].rotate.axis: "});
  check_scene(
      [](Json& s) {
        s["handles"][1]["rotate"]["axis"] = {0, 1};
      },
      {"handles[1].rotate.axis: ", "3 numbers"});
  check_scene([](Json& s) { s["handles"][1]["rotate"].erase("degrees"); },
              {"handles[1].rotate: ", "degrees"});
  check_scene([](Json& s) { s["handles"][1]["scale"] = -1; }, {"handles[1].scale: "});
  check_scene([](Json& s) { s["handles"][1]["soft"] = 0; }, {"handles[1].soft: "});
  check_scene([](Json& s) { s["handles"][1]["name"] = "left"; }, {"handles[1]: ", "'left'"});
  check_scene(
      [](Json& s) {
        s["handles"][0]["keyframes"] = {{{"time", 1}}, {{"time", 1}}};
      },
      {"handles[0].keyframes[1].time: "});
  check_scene([](Json& s) { s["handles"][1]["keyframes"] = {{{"time", 1}}}; }, {"handles[1]: give either"});
  check_scene([](Json& s) { s["handles"] = Json::array(); }, {"handles: "});
  check_scene([](Json& s) { s["frames"] = 0; }, {"frames: "});
  check_scene([](Json& s) { s["initial_guess"] = "good"; }, {"initial_guess: ", "harmonic"});
  check_scene([](Json& s) { s["newton"] = {{"projection", "sharp"}}; }, {"newton.projection: ", "adaptive"});
  check_scene(
      [](Json& s) {
        s["newton"]["linear_solver"] = {{"backend", "abacus"}};
      },
      {"newton.linear_solver.backend: ", "abacus"});
  check_scene([](Json& s) { s["format"] = "gif"; }, {"format: ", "vtu"});
  check_scene(
      [](Json& s) {
        s["format"] = "msh";
        s["order"] = 2;
      },
      {"format: ", "quadratic"});
}

TEST_CASE("deform: a region without elements, and keyframes too far apart") {
  check_scene(
      [](Json& s) {
        s["regions"] = {{{"elements", Json::array()}, {"energy", "arap"}}};
      },
      {"regions[0].elements: ", "no elements"});
  check_scene(
      [](Json& s) {
        s["handles"][1].erase("rotate");
        s["handles"][1]["keyframes"] = {{{"time", -1.7e308}}, {{"time", 1.7e308}, {"translate", {1, 0, 0}}}};
      },
      {"handles[1].keyframes[1].time: ", "too far"});
}

TEST_CASE("deform: a scene without handles is the scene's fault, and what comes before is said first") {
  check_scene([](Json& s) { s.erase("handles"); }, {"scene.json: handles: there must be one"});
  check_scene([](Json& s) { s.erase("handles"), s["energy"] = "rubber"; }, {"energy: unknown"});
}

TEST_CASE("deform: JSON that is too deep or has numbers too large is bad input") {
  const Scratch scratch;
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
    check_failure(scratch, {scratch.write("odd.json", text), "-o", scratch.path("out")}, 3, words);
  };
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  refused(deep, {"odd.json: ", "64 deep"});
  refused("{\"mesh\": " + deep + "}", {"odd.json: ", "64 deep"});
  refused("{\"mesh\": [[[1, 2]]]}", {"mesh: must be an object", "a list of 1"});
  refused("{\"frames\": 1e999}", {"odd.json: ", "1e999"});
}

TEST_CASE("deform: a restart.json that is damaged is refused, with what is wrong in it") {
  const Scratch scratch;
  const std::string scene = write_scene(scratch, pulled_bar({0.1, 0, 0})), out = scratch.path("out");
  REQUIRE(deform({scene, "-o", out, "--no-picture"}).code == 0);
  const Json good = Json::parse(read_file(out + "/restart.json"));
  const auto damaged = [&](const std::function<void(Json&)>& change, const std::string& word) {
    Json state = good;
    change(state);
    scratch.write("out/restart.json", state.dump());
    check_failure(scratch, {scene, "-o", out, "--restart"}, 3, {"restart.json", "is damaged: ", word});
  };
  damaged([](Json& s) { s["frame"] = 2; }, "frame: ");
  damaged([](Json& s) { s["frame"] = -1; }, "frame: ");
  damaged([](Json& s) { s["frames"] = 7; }, "frames: ");
  damaged([](Json& s) { s["frames"].erase(1); }, "frames: ");
  damaged([](Json& s) { s["frames"][0] = 3; }, "frames[0]: ");
  damaged([](Json& s) { s["frames"][1].erase("inverted"); }, "frames[1]: ");
  damaged([](Json& s) { s["frames"][1]["min_det_F_element"] = 1000; }, "frames[1].min_det_F_element: ");
  damaged([](Json& s) { s["frames"][1]["seconds"] = "long"; }, "frames[1].seconds: ");
  damaged([](Json& s) { s["trace"] = 1; }, "trace: ");
  damaged([](Json& s) { s["positions"].erase(0); }, "positions: ");
  damaged([](Json& s) { s["positions"][4] = nullptr; }, "positions[4]: ");
  damaged([](Json& s) { s["scene"] = 3; }, "scene: ");
}

TEST_CASE("deform: what the command line cannot add to is said") {
  const Scratch scratch;
  Json scene = twisted_bar(30, 2);
  scene["handles"] = "none";
  check_failure(scratch, {write_scene(scratch, scene), "--handle", "all", "-o", scratch.path("out")}, 3,
                {"scene.json", "handles"});
  scene = twisted_bar(30, 2);
  scene["energy"] = 7;
  check_failure(scratch, {write_scene(scratch, scene), "-p", "mu=1", "-o", scratch.path("out")}, 3,
                {"scene.json", "energy"});
}

TEST_CASE("deform: handles that disagree on a vertex are named with it") {
  check_scene([](Json& s) { s["handles"][1]["select"] = "all"; },
              {"vertex 0 ", "handles[0] (left)", "handles[1] (right)", "different places"});
  check_scene(
      [](Json& s) {
        s["handles"][1].erase("rotate");
        s["handles"][1]["select"] = "all";
        s["handles"][1]["soft"] = 1;
      },
      {"vertex 0 ", "alike"});
  const Scratch scratch;  // but where they agree, they may share
  Json scene = twisted_bar(0, 1);
  scene["handles"][1] = {{"name", "more"},
                         {"select", {{"slab", {{"axis", "x"}, {"end", "min"}, {"fraction", 0.3}}}}}};
  CHECK(deform({write_scene(scratch, scene), "-o", scratch.path("out"), "--no-picture"}).code == 0);
}

TEST_CASE("deform: files that cannot be used are exit code 3, with file, line and element") {
  const Scratch scratch;
  const std::string out = scratch.path("out/deep");
  const std::vector<std::string> hold{"--handle", "vertices:0", "-o", out};
  const auto with = [&](const std::string& input) {
    std::vector<std::string> arguments{input};
    arguments.insert(arguments.end(), hold.begin(), hold.end());
    return arguments;
  };
  check_failure(scratch, with(scratch.path("no.msh")), 3, {"no.msh"});
  check_failure(scratch, with(scratch.path("no.json")), 3, {"no.json"});
  check_failure(scratch, with(scratch.write("bad.json", "{\n  \"mesh\": ,\n}")), 3, {"bad.json", "line 2"});
  check_failure(scratch, with(scratch.write("garbage.mesh", "Vertices zebra")), 3, {"garbage.mesh"});
  mesh::TetMesh bar = mesh::tet_bar(2, 1, 1);
  std::swap(bar.tets(3, 0), bar.tets(3, 1));
  mesh::write_tets(scratch.path("inverted.mesh"), bar);
  check_failure(scratch, with(scratch.path("inverted.mesh")), 3, {"inverted.mesh", "tet 3"});
  bar = mesh::tet_bar(2, 1, 1);
  bar.tets(5, 3) = bar.tets(5, 2);
  mesh::write_tets(scratch.path("degenerate.mesh"), bar);
  check_failure(scratch, with(scratch.path("degenerate.mesh")), 3, {"degenerate.mesh", "tet 5"});
  mesh::write_obj(scratch.path("ball.obj"), mesh::icosphere(1));
  check_failure(scratch, with(scratch.path("ball.obj")), 3, {"ball.obj", "in its plane", "vertex"});
  mesh::write_tets(scratch.path("bar.msh"), mesh::tet_bar(2, 1, 1));
  check_failure(scratch, {scratch.path("bar.msh"), "--handle", "all", "-o", out, "--restart"}, 3,
                {"restart.json"});
}

TEST_CASE("deform: wrong command lines are exit code 2") {
  const Scratch scratch;
  mesh::write_tets(scratch.path("bar.msh"), mesh::tet_bar(2, 1, 1));
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{}, "--handle"},
      {{"--handle", "half"}, "slab"},
      {{"--handle", "slab:x,min"}, "slab:AXIS"},
      {{"--handle", "slab:x,min,wide"}, "wide"},
      {{"--handle", "slab:q,min,0.1"}, "handles[0].select.slab.axis"},
      {{"--handle", "sphere:1,2"}, "sphere"},
      {{"--handle", "vertices:1,-2"}, "-2"},
      {{"--handle", "all;spin=3"}, "rotate"},
      {{"--handle", "all;scale"}, "key=value"},
      {{"--handle", "all;soft=1;soft=2"}, "twice"},
      {{"--handle", "all;rotate=90"}, "handles[0].rotate"},
      {{"--handle", "all;rotate=0,0,0:9"}, "handles[0].rotate.axis"},
      {{"--handle", "vertices:77"}, "77"},
      {{"--handle", "all", "-e", "rubber"}, "rubber"},
      {{"--handle", "all", "-p", "mu"}, "name=value"},
      {{"--handle", "all", "-p", "mu=1"}, "mu"},
      {{"--handle", "all", "--young", "1"}, "--poisson"},
      {{"--handle", "all", "--young", "1", "--poisson", "0.3"}, "material"},
      {{"--handle", "all", "--frames", "0"}, "0"},
      {{"--handle", "all", "--initial-guess", "good"}, "harmonic"},
      {{"--handle", "all", "--format", "gif"}, "vtu"},
      {{"--handle", "all", "--projection", "sharp"}, "sharp"},
      {{"--handle", "all", "--backend", "abacus"}, "abacus"},
      {{"--handle", "all", "--order", "3"}, "3"},
      {{"--no-such-option"}, "--no-such-option"},
  };
  for (const auto& [arguments, word] : wrong) {
    std::vector<std::string> command = {scratch.path("bar.msh"), "-o", scratch.path("out")};
    command.insert(command.end(), arguments.begin(), arguments.end());
    check_failure(scratch, command, 2, {word});
  }
  check_failure(scratch, {"-o", scratch.path("out")}, 2, {"input"});
  check_failure(scratch, {scratch.path("bar.msh")}, 2, {"--out"});
}

TEST_CASE("deform: output that cannot be written is exit code 4") {
  const Scratch scratch;
  const std::string scene = write_scene(scratch, twisted_bar(10, 1)),
                    file = scratch.write("file", "in the way");
  check_failure(scratch, {scene, "-o", file + "/below"}, 4, {"below"});
  std::filesystem::create_directories(scratch.path("out/frame_0000.vtu"));
  check_failure(scratch, {scene, "-o", scratch.path("out")}, 4, {"frame_0000.vtu"});
}

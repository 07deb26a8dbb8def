// What isostretch-compare says of input it cannot use, and its exit codes.
#include "compare_app.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;
using Json = nlohmann::ordered_json;

namespace {

void check_scene(const std::function<void(Json&)>& change, const std::vector<std::string>& words) {
  const Scratch scratch;
  Json scene = comparison_scene({face_problem(), bar_problem("arap")}, {"isostretch"});
  change(scene);
  std::vector<std::string> all{"scene.json: "};
  all.insert(all.end(), words.begin(), words.end());
  check_failure(scratch, {"--scene", write_scene(scratch, scene), "-o", scratch.path("out")}, 3, all);
}

}  // namespace

TEST_CASE("compare: a path that JSON cannot hold is refused by name") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("m\xff.obj"), mesh::procedural_face(3));
  check_failure(scratch, {scratch.path("m\xff.obj"), "-o", scratch.path("out")}, 2,
                {"must be UTF-8", "m\xEF\xBF\xBD.obj"});
}

TEST_CASE("compare: a wrong command line is exit code 2, and leaves nothing") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("face.obj"), mesh::procedural_face(4));
  const std::string face = scratch.path("face.obj"), out = scratch.path("out");
  check_failure(scratch, {"-o", out}, 2, {"give a mesh, or --scene"});
  check_failure(scratch, {face}, 2, {"--out"});
  check_failure(scratch, {face, "-o", out, "-m", "isostretch,magic"}, 2,
                {"--method: there is no method 'magic'; there are all, isostretch, analytic"});
  check_failure(scratch, {face, "-o", out, "-e", "arap,magic"}, 2,
                {"--energy: unknown energy 'magic'", "symmetric_dirichlet"});
  check_failure(scratch, {face, "-o", out, "-p", "magic=1"}, 2, {"--param: none of the energies", "'magic'"});
  check_failure(scratch, {face, "-o", out, "--repetitions", "0"}, 2, {"--repetitions"});
  check_failure(scratch, {face, "-o", out, "--gradient-tolerance", "-1"}, 2, {"--gradient-tolerance"});
  check_failure(scratch, {face, "-o", out, "--scene", "scene.json"}, 2, {"--scene"});
  check_failure(scratch, {"--run", "face", "-o", out}, 2, {"--run"});
  check_failure(scratch, {"--scene", face, "-o", out}, 2, {"--scene: a scene is FILE.json"});
}

TEST_CASE("compare: input that is none is exit code 3, with the file's name") {
  const Scratch scratch;
  const std::string out = scratch.path("out");
  mesh::write_obj(scratch.path("ball.obj"), mesh::icosphere(1));
  check_failure(scratch, {scratch.path("ball.obj"), "-o", out}, 3,
                {"ball.obj: ", "open the surface first, isostretch-parameterize can"});
  check_failure(scratch, {scratch.path("none.obj"), "-o", out}, 3, {"none.obj"});
  check_failure(scratch, {scratch.write("bad.obj", "v 0 0 0\nv 1 0\n"), "-o", out}, 3, {"bad.obj", "2"});
  check_failure(scratch, {"--scene", scratch.path("none.json"), "-o", out}, 3, {"none.json"});
  check_failure(scratch, {"--scene", scratch.write("cut.json", "{\n\"problems\": ["), "-o", out}, 3,
                {"cut.json", "line 2"});
}

TEST_CASE("compare: a wrong scene is exit code 3, with the path of the key") {
  check_scene([](Json& s) { s["seconds"] = 1; }, {"unknown key 'seconds'", "limits"});
  check_scene([](Json& s) { s.erase("problems"); }, {"'problems' is missing"});
  check_scene([](Json& s) { s["problems"] = Json::array(); }, {"problems: there must be one"});
  check_scene([](Json& s) { s["methods"] = {"magic"}; },
              {"methods: there is no method 'magic'", "isostretch"});
  check_scene([](Json& s) { s["repetitions"] = 0; }, {"repetitions: "});
  check_scene([](Json& s) { s["limits"]["time_limit"] = -1; }, {"time_limit: "});
  check_scene([](Json& s) { s["limits"]["memory_limit"] = 100; },
              {"memory_limit: must be 0 (none) or at least 256"});
  check_scene([](Json& s) { s["problems"][0].erase("name"); }, {"problems[0]", "'name' is missing"});
  check_scene([](Json& s) { s["problems"][0]["name"] = "a/b"; }, {"problems[0].name: ", "letters"});
  check_scene([](Json& s) { s["problems"][1]["name"] = "face"; }, {"problems[1].name: ", "taken"});
  check_scene([](Json& s) { s["problems"][0]["initial_guess"] = "rest"; },
              {"problems[0]: unknown key 'initial_guess'"});
  check_scene(
      [](Json& s) {
        s["problems"][0]["mesh"] = {{"ball", {{"cells", 4}}}};
      },
      {"problems[0].mesh: unknown key 'ball'", "face"});
  check_scene([](Json& s) { s["problems"][0]["energy"] = "magic"; }, {"problems[0].energy: ", "arap"});
  check_scene([](Json& s) { s["problems"][1]["handles"][0]["soft"] = 2; }, {"handles[0].soft: only hard"});
  check_scene(
      [](Json& s) {
        s["problems"][1]["handles"][0]["select"] = {{"nearest", 1}};
      },
      {"problems[1].handles[0].select"});
  check_scene([](Json& s) { s["problems"][1]["initial_guess"] = "good"; },
              {"problems[1].initial_guess: ", "biharmonic"});
}

TEST_CASE("compare: where the energy is not finite at the start, problem and element are named") {
  const Scratch scratch;
  Json bar = bar_problem("symmetric_dirichlet");
  bar["handles"][1]["translate"] = {-3, 0, 0};
  check_failure(
      scratch,
      {"--scene", write_scene(scratch, comparison_scene({bar}, {"isostretch"})), "-o", scratch.path("out")},
      3, {"problem 'bar_symmetric_dirichlet'", "not finite at the start, where element ", "det F = -"});
}

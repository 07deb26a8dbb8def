// What isostretch-manipulate says of bad input, and that it leaves nothing behind then.
#include "failure.hpp"
#include "manipulate_app.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

using namespace isostretch;
using namespace isostretch::test;
using Json = nlohmann::ordered_json;

namespace {

void check_failure(const Scratch& scratch, const std::vector<std::string>& arguments, int code,
                   const std::vector<std::string>& words) {
  check_failure_of([](const auto& list) { return manipulate(list); }, scratch, arguments, code, words);
}

void check_scene(const std::function<void(Json&)>& change, const std::vector<std::string>& words) {
  const Scratch scratch;
  Json scene = swirl(30, 4);
  change(scene);
  std::vector<std::string> all{"scene.json: "};
  all.insert(all.end(), words.begin(), words.end());
  check_failure(scratch, {write_scene(scratch, scene), "-o", scratch.path("out")}, 3, all);
}

}  // namespace

TEST_CASE("manipulate: a wrong scene is exit code 3, with the path of the key") {
  check_scene([](Json& s) { s["colour"] = "red"; }, {"unknown key 'colour'", "manipulation"});
  check_scene([](Json& s) { s.erase("mesh"); }, {"'mesh' is missing"});
  check_scene([](Json& s) { s["mesh"] = {{"cube", 1}}; }, {"mesh: unknown key 'cube'", "quadruped"});
  check_scene([](Json& s) { s["mesh"]["bar"] = 1; }, {"mesh: must have one of the keys"});
  check_scene([](Json& s) { s["mesh"]["grid"]["cells"] = {4}; }, {"mesh.grid.cells: must be 2"});
  check_scene([](Json& s) { s["mesh"]["grid"]["size"] = {4, 0}; }, {"mesh.grid.size[1]: "});
  check_scene([](Json& s) { s["mesh"]["grid"]["split"] = "three"; }, {"mesh.grid.split: ", "crossed"});
  check_scene([](Json& s) { s["mesh"] = {{"ball", {{"cells", 3}}}}; }, {"even"});
  check_scene(
      [](Json& s) {
        s["mesh"] = {{"bar", {{"cells", {2, 2}}, {"element", "quad"}}}};
      },
      {"mesh: only linear triangles and tets"});
  check_scene(
      [](Json& s) {
        s["mesh"] = {{"photo_grid", {{"cells", 3}}}};
      },
      {"mesh.photo_grid: ", "'photo'"});
  check_scene([](Json& s) { s["handles"][1]["soft"] = 3; },
              {"handles[1].soft: handles are soft here", "alpha"});
  check_scene([](Json& s) { s["handles"][1]["hard"] = 3; }, {"handles[1].hard: must be true or false"});
  check_scene([](Json& s) { s["handles"][1]["select"] = s["handles"][0]["select"]; },
              {"vertex 0 is in handles[0] (boundary) and in handles[1] (middle)"});
  check_scene(
      [](Json& s) {
        s["handles"][1]["select"] = s["handles"][0]["select"];
        s["handles"][1].erase("rotate");
      },
      {"handles[1]: all its vertices are in handles before"});
  check_scene([](Json& s) { s["manipulation"]["alpha"] = 0; }, {"alpha: "});
  check_scene([](Json& s) { s["manipulation"]["element_weights"] = "heavy"; },
              {"element_weights: ", "volume"});
  check_scene([](Json& s) { s["manipulation"]["length_unit"] = "inch"; }, {"length_unit: ", "diagonal"});
  check_scene([](Json& s) { s["manipulation"]["incompressibility"] = -1; }, {"incompressibility: "});
  check_scene([](Json& s) { s["manipulation"]["margin"] = 1; }, {"margin: "});
  check_scene([](Json& s) { s["manipulation"]["rotations"] = "round"; }, {"rotations: ", "biharmonic"});
  check_scene([](Json& s) { s["manipulation"]["blend"] = "mix"; }, {"blend: ", "aligned_quaternion"});
  check_scene([](Json& s) { s["manipulation"]["method"] = "guess"; }, {"method: ", "interior_point"});
  check_scene([](Json& s) { s["manipulation"]["gap_tolerance"] = 2; }, {"gap_tolerance: "});
  check_scene([](Json& s) { s["manipulation"]["max_iterations"] = -1; }, {"max_iterations: "});
  check_scene([](Json& s) { s["format"] = "gif"; }, {"format: ", "vtu"});
  check_scene([](Json& s) { s["up"] = "w"; }, {"up: "});
  check_scene([](Json& s) { s["photo"] = {{"file", "a.png"}, {"fit", "wide"}}; }, {"photo.fit: ", "pixels"});
}

TEST_CASE("manipulate: handles with different axes cannot be blended by angle") {
  const Scratch scratch;
  Json scene = squashed_bar();
  scene["handles"][0]["rotate"] = {{"axis", {0, 1, 0}}, {"degrees", 30}};
  scene["manipulation"]["blend"] = "angle";
  check_failure(scratch, {write_scene(scratch, scene), "-o", scratch.path("out")}, 3, {"scene.json: ", "ax"});
}

TEST_CASE("manipulate: a frame whose rotations cancel in an element fails alone") {
  const Scratch scratch;
  const auto end = [](const char* which) {
    return Json{{"slab", {{"axis", "x"}, {"end", which}, {"fraction", 0.01}}}};
  };
  // Half-way between the ends, in the middle of an odd number of cells, the weights are equal, and a full
  // turn is -1 as a quaternion.
  const Json scene{
      {"mesh", {{"grid", {{"cells", {3, 1}}, {"size", {3, 1}}}}}},
      {"handles", {{{"select", end("min")}}, {{"select", end("max")}, {"rotate", {{"degrees", 360}}}}}},
      {"manipulation", {{"blend", "quaternion"}}},
      {"frames", 2}};
  const Outcome run = manipulate({write_scene(scratch, scene), "-o", scratch.path("out"), "--no-picture"});
  CHECK(run.code == 6);
  CHECK(run.err.find("frame 2") != std::string::npos);
  const auto summary = read_json(scratch.path("out/summary.json"));
  REQUIRE(summary["frames"].size() == 3);
  CHECK(summary["frames"][1]["certified"] == true);
  CHECK(summary["frames"][2]["status"] == "failed");
  CHECK(summary["frames"][2]["message"].get<std::string>().find("element") != std::string::npos);
  CHECK(std::filesystem::exists(scratch.path("out/frame_0001.vtu")));
  CHECK(!std::filesystem::exists(scratch.path("out/frame_0002.vtu")));
}

TEST_CASE("manipulate: pictures that are none are named") {
  const Scratch scratch;
  const std::string scene = write_scene(scratch, swirl(30, 4)),
                    text = scratch.write("text.png", "no picture");
  check_failure(scratch, {scene, "-o", scratch.path("out"), "--photo", scratch.path("none.png")}, 3,
                {"none.png: cannot be read"});
  check_failure(scratch, {scene, "-o", scratch.path("out"), "--photo", text}, 3, {"text.png: is no PNG"});
  check_failure(scratch,
                {"-o", scratch.path("out"), "--photo", text, "--photo-cells", "4", "--handle", "all"}, 3,
                {"text.png: is no PNG"});
  const std::string bar = write_scene(scratch, squashed_bar(), "bar.json");
  check_failure(scratch, {bar, "-o", scratch.path("out"), "--photo", text}, 3, {"photo: ", "plane"});
}

TEST_CASE("manipulate: a wrong command line is exit code 2") {
  const Scratch scratch;
  const std::string out = scratch.path("out"), scene = write_scene(scratch, swirl(30, 4));
  const std::string grid = scratch.write("grid.obj", mesh::format_obj(mesh::grid(3, 3)));
  check_failure(scratch, {"-o", out, "--handle", "all"}, 2, {"no mesh"});
  check_failure(scratch, {grid, "-o", out}, 2, {"--handle: there must be one"});
  check_failure(scratch, {grid, "-o", out, "--handle", "all;soft=3"}, 2, {"handles are soft here", "alpha"});
  check_failure(scratch, {grid, "-o", out, "--handle", "ring:1"}, 2, {"no selection", "segment"});
  check_failure(scratch, {grid, "-o", out, "--handle", "all", "--refine", "2"}, 2, {"--refine", "file"});
  check_failure(scratch, {grid, "-o", out, "--handle", "all", "--photo-cells", "2"}, 2, {"--photo-cells"});
  check_failure(scratch, {scene, "-o", out, "--photo-fit", "box"}, 2, {"--photo-fit"});
  check_failure(scratch, {scene, "-o", out, "--frames", "2:1"}, 2, {"--frames", "2:1"});
  check_failure(scratch, {scene, "-o", out, "--frames", "1:2:3"}, 2, {"--frames"});
  check_failure(scratch, {scene, "-o", out, "--frames", "0"}, 2, {"--frames", "'0'"});
  check_failure(scratch, {scene, "-o", out, "--frames", "1:2"}, 2, {"no frame 2"});
  check_failure(scratch, {scene, "-o", out, "--method", "luck"}, 2, {"--method", "luck"});
  check_failure(scratch, {scene, "-o", out, "--gap-tolerance", "nan"}, 2, {"--gap-tolerance"});
  check_failure(scratch, {scene}, 2, {"--out"});
}

TEST_CASE("manipulate: meshes that cannot be used and folders that cannot be made") {
  const Scratch scratch;
  check_failure(scratch, {scratch.path("none.obj"), "-o", scratch.path("out"), "--handle", "all"}, 3,
                {"none.obj"});
  const std::string file = scratch.write("file", "");
  const std::string scene = write_scene(scratch, swirl(30, 4)), out = scratch.path("out");
  check_failure(scratch, {scene, "-o", file}, 4, {"is not a folder"});
  check_failure(scratch, {scene, "-o", out, "--weights-cache", file}, 4, {"is not a folder"});
}

TEST_CASE("manipulate: --help explains handles, options and exit codes") {
  const Outcome help = manipulate({"--help"});
  CHECK(help.code == 0);
  for (const char* word : {"--handle", "segment:", "hard", "--alpha", "--photo", "--weights-cache",
                           "--frames", "interior_point", "Exit codes"})
    CHECK_MESSAGE(help.out.find(word) != std::string::npos, word);
}

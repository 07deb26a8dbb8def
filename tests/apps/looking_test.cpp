// What apps show before anything is solved: --check of bodies, --preview of handles, and scenes by name.
#include "compare_app.hpp"
#include "deform_app.hpp"
#include "interpolate_app.hpp"
#include "manipulate_app.hpp"
#include "paths.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace isostretch::test;

namespace {

bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

// MEDIT, with tets given by vertices from 1 and a reference each.
std::string medit(const std::string& vertices, int vertex_count, const std::string& tets, int tet_count) {
  return "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(vertex_count) + "\n" + vertices +
         "Tetrahedra\n" + std::to_string(tet_count) + "\n" + tets + "End\n";
}

const std::string corners = "0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n9 9 9 0\n";
// Two tets at a common face.
const std::string pair = medit(corners, 6, "1 2 3 4 7\n2 3 4 5 8\n", 2);
// The second one is the other way round.
const std::string inverted = medit(corners, 6, "1 2 3 4 7\n2 4 3 5 8\n", 2);

void check_refused(const Outcome& said, const std::vector<std::string>& words) {
  CHECK(said.code == 3);
  for (const std::string& word : words) CHECK_MESSAGE(has(said.out, word), said.out);
  CHECK(has(said.out, "It cannot be used as it is: "));
}

}  // namespace

TEST_CASE("--check of a body says what a user wants to know, and makes nothing") {
  const Scratch scratch;
  const std::string mesh = scratch.write("pair.mesh", pair);
  for (const Outcome& said : {deform({mesh, "--check"}), manipulate({mesh, "--check"})}) {
    CHECK_MESSAGE(said.code == 0, said.err);
    for (const char* words :
         {"pair.mesh: 2 tets, 6 vertices (1 of no element)", "box: (0, 0, 0) to (1, 1, 1), diagonal 1.73205",
          "components: 1\n", "group 7: 1 tet\n", "group 8: 1 tet\n", "volume: 0.5\n",
          "smallest: tet 0 (vertices 0 1 2 3), volume 0.166667",
          "largest: tet 1 (vertices 1 2 3 4), volume 0.333333",
          "worst shape: tet 0 (vertices 0 1 2 3), scaled Jacobian 0.707", "It can be used.\n"})
      CHECK_MESSAGE(has(said.out, words), said.out);
  }
  CHECK(deform({mesh, "--check", "-q"}).out.empty());
  CHECK(scratch.contents().size() == 1);
}

TEST_CASE("--check names what is inverted, there twice, degenerate or out of the plane, and ends with 3") {
  const Scratch scratch;
  const std::string turned = scratch.write("inverted.mesh", inverted);
  check_refused(deform({turned, "--check"}), {"inverted, or numbered the other way round: 1 tet",
                                              "    tet 1 (vertices 1 3 2 4)\n", "has negative volume"});
  check_refused(manipulate({turned, "--check"}), {"tet 1 (vertices 1 3 2 4)"});
  CHECK(deform({turned, "--check", "--repair"}).code == 0);

  const std::string twice = scratch.write("twice.mesh", medit(corners, 6, "1 2 3 4 7\n2 3 1 4 7\n", 2));
  check_refused(deform({twice, "--check"}), {"there twice: 1 tet", "tet 1 (vertices 1 2 0 3)"});
  CHECK(deform({twice, "--check", "--repair"}).code == 0);

  const std::string flat =
      scratch.write("flat.mesh", medit("0 0 0 0\n1 0 0 0\n0 1 0 0\n1 1 0 0\n", 4, "1 2 3 4 0\n", 1));
  check_refused(deform({flat, "--check"}),
                {"zero volume", "scaled Jacobian 0 ", "tet 0 (vertices 0 1 2 3), volume 0\n"});

  const std::string doubled = scratch.write("doubled.mesh", medit(corners, 6, "1 2 3 3 0\n", 1));
  check_refused(deform({doubled, "--check"}), {"degenerate element: 1\n", "tet 0 (vertices 0 1 2 2)"});

  const std::string bent =
      scratch.write("bent.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 2 4 3\n");
  check_refused(deform({bent, "--check"}), {"2 triangles", "stands "});

  const std::string clockwise =
      scratch.write("clockwise.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n");
  check_refused(deform({clockwise, "--check"}), {"inverted, or numbered the other way round: 1 triangle"});

  const Outcome none = deform({scratch.path("none.mesh"), "--check"});
  CHECK(none.code == 3);
  CHECK_MESSAGE(has(none.err, "none.mesh"), none.err);
}

TEST_CASE("--check knows every kind of element, parts, and bodies that scenes make") {
  const Scratch scratch;
  for (const char* kind : {"tet", "hex", "quadratic_tet"}) {
    const auto scene = write_scene(
        scratch, {{"mesh", {{"bar", {{"cells", {2, 1, 1}}, {"size", {2, 1, 1}}, {"element", kind}}}}}});
    const Outcome said = deform({scene, "--check"});
    CHECK_MESSAGE(said.code == 0, said.err);
    CHECK_MESSAGE(has(said.out, "  volume: 2\n"), said.out);
    CHECK_MESSAGE(has(said.out, "components: 1\n"), said.out);
    if (std::string(kind) == "hex") CHECK_MESSAGE(has(said.out, "2 hexes, 12 vertices"), said.out);
    if (std::string(kind) == "hex") CHECK_MESSAGE(has(said.out, "scaled Jacobian 1 "), said.out);
    CHECK(manipulate({scene, "--check"}).code == (std::string(kind) == "tet" ? 0 : 3));
  }
  for (const char* kind : {"triangle", "quad", "quadratic_triangle"}) {
    const auto scene = write_scene(scratch, {{"mesh", {{"bar", {{"cells", {3, 2}}, {"element", kind}}}}}});
    const Outcome said = deform({scene, "--check"});
    CHECK_MESSAGE(said.code == 0, said.err);
    CHECK_MESSAGE(has(said.out, "  area: 1\n"), said.out);
  }
  const std::string far = "5 0 0 0\n6 0 0 0\n5 1 0 0\n5 0 1 0\n";
  const std::string parts =
      scratch.write("parts.mesh", medit("0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n" + far, 9,
                                        "1 2 3 4 0\n2 3 4 5 0\n6 7 8 9 0\n", 3));
  const Outcome said = deform({parts, "--check"});
  CHECK(said.code == 0);
  CHECK_MESSAGE(has(said.out, "components: 2, of 2, 1 tets\n"), said.out);
  CHECK(deform({write_scene(scratch, {{"mesh", "parts.mesh"}}), "--check"}).out.size() >= said.out.size());
}

TEST_CASE("interpolate --check looks at both poses and whether they belong together") {
  const Scratch scratch;
  const std::string a = scratch.write("a.mesh", pair), bad = scratch.write("bad.mesh", inverted);
  const std::string one = scratch.write("one.mesh", medit(corners, 6, "1 2 3 4 7\n", 1));
  const Outcome good = interpolate({a, a, "--check"});
  CHECK_MESSAGE(good.code == 0, good.err);
  CHECK(has(good.out, "The poses belong together."));
  check_refused(interpolate({a, bad, "--check"}), {"a.mesh: 2 tets", "bad.mesh: 2 tets", "It can be used."});
  const Outcome other = interpolate({a, one, "--check"});
  CHECK(other.code == 3);
  CHECK_MESSAGE(has(other.out, "The poses do not belong together: "), other.out);
  CHECK_MESSAGE(has(other.out, "one.mesh has 1 tets"), other.out);
  CHECK(scratch.contents().size() == 3);
}

TEST_CASE("--out is needed for everything but --check") {
  const Scratch scratch;
  const std::string mesh = scratch.write("pair.mesh", pair);
  for (const Outcome& said : {deform({mesh, "--handle", "all"}), manipulate({mesh, "--handle", "all"}),
                              interpolate({mesh, mesh}), deform({mesh, "--handle", "all", "--preview"})}) {
    CHECK(said.code == 2);
    CHECK_MESSAGE(has(said.err, "--out"), said.err);
  }
  CHECK(deform({mesh, "--check", "--preview", "-o", scratch.path("out")}).code == 2);
}

TEST_CASE("--preview prints the handles, draws them, and solves nothing") {
  const Scratch scratch;
  const auto bar = write_scene(scratch, twisted_bar(90, 4));
  for (const Outcome& said : {deform({bar, "--preview", "-o", scratch.path("deform")}),
                              manipulate({write_scene(scratch, squashed_bar(), "squash.json"), "--preview",
                                          "-o", scratch.path("manipulate")})}) {
    CHECK_MESSAGE(said.code == 0, said.err);
    std::istringstream lines(said.out);
    std::string head, left, right;
    std::getline(lines, head), std::getline(lines, left), std::getline(lines, right);
    CHECK_MESSAGE(std::regex_match(head, std::regex("handle  kind  nodes  centre +goes to +farthest  turns")),
                  head);
    CHECK_MESSAGE(has(left, "left    "), said.out);
    CHECK_MESSAGE(has(left, "  9      (0, 0.5, 0.5)"), said.out);
    CHECK_MESSAGE(has(left, "stays"), said.out);
    CHECK_MESSAGE(has(right, " deg"), said.out);
    CHECK(has(said.out, "preview.png\n"));
  }
  for (const char* folder : {"deform", "manipulate"}) {
    std::vector<std::string> made;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path(folder)))
      made.push_back(entry.path().filename().string());
    CHECK(made == std::vector<std::string>{"preview.png"});
    CHECK(read_file(scratch.path(folder) + "/preview.png").substr(1, 3) == "PNG");
  }
  // Columns stand below each other whatever letters names have.
  auto named = twisted_bar(90, 1);
  named["handles"][0]["name"] = "Ärmel";
  const Outcome said =
      deform({write_scene(scratch, named, "named.json"), "--preview", "-o", scratch.path("deform")});
  CHECK_MESSAGE(has(said.out, "\nÄrmel   hard  9"), said.out);
  // Where the end is, and how far it goes: a corner of a square of side 1 by a quarter turn about its middle.
  CHECK_MESSAGE(has(deform({bar, "--preview", "-o", scratch.path("deform")}).out,
                    "right   hard  9      (4, 0.5, 0.5)  (4, 0.5, 0.5)  1         90 deg"),
                "far");
}

TEST_CASE("--preview warns of parts without a handle and refuses what a run would refuse") {
  const Scratch scratch;
  const std::string parts = scratch.write(
      "parts.mesh", medit("0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 0 0 0\n6 0 0 0\n5 1 0 0\n5 0 1 0\n", 8,
                          "1 2 3 4 0\n5 6 7 8 0\n", 2));
  for (const auto app : {deform, manipulate}) {
    const Outcome said = app(
        {parts, "--handle", "vertices:0;translate=0,0,1;name=tip", "--preview", "-o", scratch.path("out")},
        {});
    CHECK_MESSAGE(said.code == 0, said.err);
    CHECK_MESSAGE(has(said.err, "have no handle"), said.err);
    CHECK_MESSAGE(has(said.out, "tip     "), said.out);
    const Outcome empty =
        app({parts, "--handle", "sphere:50,0,0,1", "--preview", "-o", scratch.path("none")}, {});
    CHECK(empty.code == 2);
    CHECK(!std::filesystem::exists(scratch.path("none")));
  }
}

TEST_CASE("scenes that come with the program are found by name, wherever it runs") {
  const Scratch scratch;
  for (const char* name : {"yogurt180", "yogurt180.json"}) {
    const Outcome said = manipulate({name, "--preview", "-o", scratch.path("out")});
    CHECK_MESSAGE(said.code == 0, said.err);
    CHECK_MESSAGE(has(said.out, "180 deg"), said.out);
  }
  const Outcome run = manipulate({"yogurt90", "-o", scratch.path("run"), "--no-picture"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(read_json(scratch.path("run/summary.json"))["frames"].size() == 2);
  CHECK(manipulate({"noose", "--check"}).code == 0);
}

TEST_CASE("a file comes before the scene of its name, and its mesh is sought beside it") {
  const Scratch scratch;
  scratch.write("pair.mesh", pair);
  const auto own =
      write_scene(scratch, {{"mesh", "pair.mesh"}, {"handles", {{{"select", "all"}}}}}, "yogurt180.json");
  const Outcome said = manipulate({own, "--check"});
  CHECK_MESSAGE(said.code == 0, said.err);
  CHECK_MESSAGE(has(said.out, "2 tets"), said.out);
}

TEST_CASE("a name that is neither a file nor a scene is an error that says both") {
  const Scratch scratch;
  for (const char* name : {"yoghurt180", "yoghurt180.json"}) {
    const Outcome said = manipulate({name, "-o", scratch.path("out")});
    CHECK(said.code == 3);
    CHECK_MESSAGE(has(said.err, std::string(name) + ": there is no file of that name, and no scene of that "
                                                    "name comes with the program (--list-scenes"),
                  said.err);
    CHECK(has(compare({"--scene", name, "-o", scratch.path("out")}).err, "no scene of that name"));
  }
  // In a folder, or with another extension, it can only be a file.
  CHECK(has(manipulate({scratch.path("yogurt180.json"), "-o", scratch.path("out")}).err, "cannot be read"));
  CHECK(!has(manipulate({"yogurt180.msh", "--handle", "all", "-o", scratch.path("out")}).err, "scene"));
  CHECK(!std::filesystem::exists(scratch.path("out")));
}

TEST_CASE("--list-scenes has every scene with what it shows") {
  const Outcome said = manipulate({"--list-scenes"});
  CHECK(said.code == 0);
  std::istringstream lines(said.out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    CHECK_MESSAGE(line.size() <= 80, line);
    CHECK_MESSAGE(line.size() > 30, line);
    const std::string name = line.substr(0, line.find(' '));
    CHECK(std::filesystem::exists(
        isostretch::tests::source_path("apps/isostretch-manipulate/scenes/" + name + ".json")));
    CHECK_MESSAGE(manipulate({name, "--check"}).code == 0, name);
  }
  CHECK(count == 15);
  CHECK(has(compare({"--list-scenes"}).out, "compare  Every method"));
}

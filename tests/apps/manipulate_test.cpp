// The main job of isostretch-manipulate: frames without inverted elements, certificates, photos, the cache.
#include "manipulate_app.hpp"
#include "paths.hpp"

#include <isostretch/figures/photo.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;
using figures::Photo;
using Json = nlohmann::ordered_json;

namespace {

// Runs the scene, which must end well, and returns summary.json.
nlohmann::json solved(const Scratch& scratch, const Json& scene, std::vector<std::string> more = {},
                      const std::string& out = "out") {
  std::vector<std::string> arguments{write_scene(scratch, scene), "-o", scratch.path(out), "--no-picture"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome run = manipulate(arguments);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  return read_json(scratch.path(out + "/summary.json"));
}

bool same_file(const Scratch& scratch, const std::string& a, const std::string& b) {
  return read_file(scratch.path(a)) == read_file(scratch.path(b));
}

// Every pixel different, half of them translucent.
Photo test_photo(int width, int height) {
  Photo photo(width, height);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const auto x = static_cast<std::uint32_t>(i), y = static_cast<std::uint32_t>(j);
      const std::uint32_t red = (37 * x + 11 * y) % 101, green = (13 * x * y) % 101, blue = (53 * y) % 101;
      const std::uint32_t alpha = (i + j) % 2 == 0 ? 255 : 128;
      photo.set_pixel(i, j, alpha << 24 | red << 16 | green << 8 | blue);
    }
  return photo;
}

int largest_difference(const Photo& a, const Photo& b) {
  int most = 0;
  for (int j = 0; j < a.height(); ++j)
    for (int i = 0; i < a.width(); ++i)
      for (int shift = 0; shift < 32; shift += 8) {
        const int p = static_cast<int>(a.pixel(i, j) >> shift & 0xFFU),
                  q = static_cast<int>(b.pixel(i, j) >> shift & 0xFFU);
        most = std::max(most, std::abs(p - q));
      }
  return most;
}

}  // namespace

TEST_CASE("manipulate: a swirl of 180 degrees: all files, no inverted element, a certificate") {
  const Scratch scratch;
  const Outcome run = manipulate({write_scene(scratch, swirl(180)), "--out", scratch.path("out")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  for (const char* file : {"frame_0000.vtu", "frame_0001.vtu", "weights.vtu", "summary.json", "trace.csv",
                           "manipulate.png", "path.png", "manipulate.pvd", "report.html"})
    CHECK_MESSAGE(std::filesystem::exists(scratch.path(std::string("out/") + file)), file);
  const auto summary = read_json(scratch.path("out/summary.json"));
  CHECK(summary["certified"] == true);
  CHECK(summary["totals"]["frames_with_inverted"] == 0);
  const auto& f = summary["frames"][1];
  CHECK(f["status"] == "optimal");
  CHECK(f["inverted_before"].get<int>() > 0);
  CHECK(f["not_psd_before"].get<int>() >= f["inverted_before"].get<int>());
  CHECK(f["inverted"] == 0);
  CHECK(f["not_psd"] == 0);
  CHECK(f["min_det_F"].get<double>() > 0);
  CHECK(f["min_eigenvalue"].get<double>() >= 0);
  CHECK(f["gap"].get<double>() <= 1e-6);
  CHECK(f["elastic_energy"].get<double>() + f["target_energy"].get<double>() ==
        Approx(f["energy"].get<double>()));
  CHECK(f["lower_bound"].get<double>() <= f["energy"].get<double>());
  const std::string trace = read_file(scratch.path("out/trace.csv"));
  CHECK(trace.rfind("frame,iteration,", 0) == 0);
  CHECK(std::count(trace.begin(), trace.end(), '\n') == 2 + f["iterations"].get<int>());
  CHECK(read_file(scratch.path("out/path.png")).substr(1, 3) == "PNG");
  const std::string vtu = read_file(scratch.path("out/frame_0001.vtu"));
  for (const char* field : {"min_eig_S", "det_F", "length_change", "displacement"})
    CHECK_MESSAGE(vtu.find(field) != std::string::npos, field);
  CHECK(read_file(scratch.path("out/weights.vtu")).find("weight_1") != std::string::npos);
}

TEST_CASE("manipulate: a bar of tets pushed through itself comes out without an inverted element") {
  const Scratch scratch;
  const auto summary = solved(scratch, squashed_bar());
  CHECK(summary["frames"][1]["inverted_before"].get<int>() > 50);
  CHECK(summary["frames"][1]["inverted"] == 0);
  const mesh::TetMesh last = mesh::read_vtu_tets(scratch.path("out/frame_0001.vtu"));
  CHECK(last.tets == mesh::tet_bar(6, 2, 2, 3, 1, 1).tets);
}

TEST_CASE("manipulate: every frame stands for itself, and for any number of threads") {
  const Scratch scratch;
  const Json scene = swirl(240, 6, 3);
  const auto whole = solved(scratch, scene, {"--threads", "1"}, "whole");
  const auto part = solved(scratch, scene, {"--frames", "2:2", "--threads", "2"}, "part");
  CHECK(whole["frames"].size() == 4);
  CHECK(part["frames"].size() == 2);
  CHECK(part["totals"]["frames_wanted"] == 1);
  CHECK(same_file(scratch, "whole/frame_0002.vtu", "part/frame_0002.vtu"));
  CHECK(!same_file(scratch, "whole/frame_0003.vtu", "part/frame_0002.vtu"));
  CHECK(!std::filesystem::exists(scratch.path("part/frame_0001.vtu")));
  CHECK(!std::filesystem::exists(scratch.path("part/frame_0003.vtu")));
  CHECK(whole["frames"][2]["energy"] == part["frames"][1]["energy"]);
  CHECK(part["frames"][1]["time"].get<double>() == Approx(2.0 / 3));
}

TEST_CASE("manipulate: the result does not depend on the units of the mesh, unless asked") {
  const Scratch scratch;
  Json scene = swirl(90, 4);
  const double small = solved(scratch, scene)["frames"][1]["energy"];
  scene["mesh"]["grid"]["size"] = {10, 10};
  scene["handles"][0]["select"]["patch"]["distance"] = 100;
  scene["handles"][1]["select"]["sphere"] = {{"center", {5, 5}}, {"radius", 1.3}};
  CHECK(solved(scratch, scene)["frames"][1]["energy"].get<double>() == Approx(small).epsilon(1e-5));
  CHECK(solved(scratch, scene, {"--length-unit", "mesh"})["frames"][1]["energy"].get<double>() >
        1.002 * small);
}

TEST_CASE("manipulate: a hard handle arrives, soft ones nearly") {
  const Scratch scratch;
  Json scene = squashed_bar();
  scene["handles"][1].erase("rotate");
  scene["handles"][1]["translate"] = {0.5, 0.25, 0};
  scene["handles"][1]["hard"] = true;
  const auto summary = solved(scratch, scene);
  CHECK(summary["handles"][0]["kind"] == "soft");
  CHECK(summary["handles"][1]["kind"] == "hard");
  const mesh::Points3 rest = mesh::tet_bar(6, 2, 2, 3, 1, 1).vertices,
                      moved = mesh::read_vtu_tets(scratch.path("out/frame_0001.vtu")).vertices;
  double soft = 0;
  for (Eigen::Index v = 0; v < rest.rows(); ++v) {
    if (rest(v, 0) == 3)
      CHECK((moved.row(v) - rest.row(v) - Eigen::RowVector3d(0.5, 0.25, 0)).norm() < 1e-14);
    if (rest(v, 0) == 0) soft = std::max(soft, (moved.row(v) - rest.row(v)).norm());
  }
  CHECK(soft > 1e-10);
  CHECK(soft < 0.1);
}

TEST_CASE("manipulate: a component without a handle stays, with a warning") {
  const Scratch scratch;
  mesh::SurfaceMesh two = mesh::grid(2, 2), one = two;
  two.vertices.conservativeResize(18, 3);
  two.vertices.bottomRows(9) = one.vertices.rowwise() + Eigen::RowVector3d(3, 0, 0);
  two.triangles.conservativeResize(16, 3);
  two.triangles.bottomRows(8) = one.triangles.array() + 9;
  const std::string file = scratch.write("two.obj", mesh::format_obj(two));
  const Outcome run = manipulate({file, "--handle", "vertices:0;translate=0.1,0.2", "-o", scratch.path("out"),
                                  "--format", "obj", "--no-picture"});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run.err.find("have no handle and stay") != std::string::npos);
  const mesh::Points3 moved = mesh::read_surface(scratch.path("out/frame_0001.obj")).vertices;
  CHECK(moved.bottomRows(9) == two.vertices.bottomRows(9));
  CHECK((moved.row(0) - Eigen::RowVector3d(0.1, 0.2, 0)).norm() < 1e-6);
}

TEST_CASE("manipulate: generated bodies are refined, --mesh replaces that of the scene") {
  const Scratch scratch;
  CHECK(solved(scratch, swirl(30, 2), {"--refine", "3"})["mesh"]["elements"] == 4 * 36);
  Json scene{{"mesh", {{"ball", {{"cells", 2}}}}},
             {"handles", {{{"select", {{"nearest", {{"point", {0, 0, 1}}}}}}}}}};
  CHECK(solved(scratch, scene, {"--refine", "2"})["mesh"]["elements"] == 5 * 64);
  scene["mesh"] = {{"disc", {{"rings", 3}}}};
  scene["handles"][0]["select"]["nearest"]["point"] = {0, 1};
  CHECK(solved(scratch, scene)["mesh"]["elements"] == 54);
  const std::string file = scratch.write("grid.obj", mesh::format_obj(mesh::grid(3, 3)));
  CHECK(solved(scratch, scene, {"--mesh", file})["mesh"]["elements"] == 18);
}

TEST_CASE("manipulate: a segment selects what is near a bone, on the command line as in a scene") {
  const Scratch scratch;
  const std::string file = scratch.write("grid.obj", mesh::format_obj(mesh::grid(4, 4)));
  const Outcome run = manipulate({file, "--handle", "segment:0.25,0,0.75,0,0.1", "--handle", "slab:y,max,0.1",
                                  "-o", scratch.path("text"), "--no-picture"});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(read_json(scratch.path("text/summary.json"))["handles"][0]["nodes"] == 3);
  Json scene = swirl(20, 4);
  scene["handles"][1]["select"] = {
      {"segment", {{"from", {0.25, 0.5}}, {"to", {0.75, 0.5}}, {"distance", 0.01}}}};
  CHECK(solved(scratch, scene)["handles"][1]["nodes"] == 3);
}

TEST_CASE("manipulate: weights come from the cache the second time, and change nothing") {
  const Scratch scratch;
  const Json scene = swirl(150, 6);
  const std::vector<std::string> cache{"--weights-cache", scratch.path("cache")};
  std::filesystem::create_directory(scratch.path("cache"));
  CHECK(solved(scratch, scene, cache, "first")["handle_weights"]["from_cache"] == false);
  CHECK(solved(scratch, scene, cache, "second")["handle_weights"]["from_cache"] == true);
  CHECK(same_file(scratch, "first/frame_0001.vtu", "second/frame_0001.vtu"));
  CHECK(same_file(scratch, "first/weights.vtu", "second/weights.vtu"));
}

TEST_CASE("manipulate: a photo comes out as it is when nothing moves") {
  const Scratch scratch;
  const Photo photo = test_photo(61, 40);
  const std::string file = scratch.write("photo.png", photo.png());
  const Outcome run = manipulate({"--photo", file, "--photo-cells", "7", "--handle", "all", "--rotations",
                                  "none", "-o", scratch.path("out"), "--no-picture"});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const Photo drawn = figures::read_photo(scratch.path("out/photo_0001.png"));
  REQUIRE(drawn.width() == 61);
  REQUIRE(drawn.height() == 40);
  CHECK(largest_difference(photo, drawn) <= 1);
}

TEST_CASE("manipulate: a photo moved by whole pixels is the photo, with transparency around it") {
  const Scratch scratch;
  const Photo photo = test_photo(40, 40);
  const std::string file = scratch.write("photo.png", photo.png());
  const Json scene{{"mesh", {{"grid", {{"cells", {4, 4}}, {"size", {40, 40}}}}}},
                   {"photo", {{"file", file}, {"fit", "pixels"}}},
                   {"manipulation", {{"rotations", "none"}}},
                   {"handles", {{{"select", "all"}, {"translate", {5, 10}}}}}};
  solved(scratch, scene);
  const Photo drawn = figures::read_photo(scratch.path("out/photo_0001.png"));
  REQUIRE(drawn.width() == 45);
  REQUIRE(drawn.height() == 50);
  CHECK(drawn.pixel(0, 49) == 0);
  Photo inner(40, 40);
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 40; ++i) inner.set_pixel(i, j, drawn.pixel(i + 5, j));
  CHECK(largest_difference(photo, inner) <= 1);
}

TEST_CASE("manipulate: stretch is bounded where asked, and rounds of re-linearisation lower the energy") {
  const Scratch scratch;
  Json scene = swirl(150);
  const auto free = solved(scratch, scene);
  const double most = free["frames"][1]["max_length_change"];
  scene["manipulation"]["margin"] = 0.2;
  scene["manipulation"]["largest_stretch"] = 1 + 0.8 * (most - 1);
  const auto bounded = solved(scratch, scene, {}, "bounded");
  CHECK(bounded["frames"][1]["energy"] > free["frames"][1]["energy"]);
  CHECK(bounded["frames"][1]["max_length_change"] <= 1 / 0.2 + 1e-9);
  scene = swirl(150);
  const auto relinearized = solved(scratch, scene, {"--relinearize", "200"}, "relinearized");
  const auto& rounds = relinearized["frames"][1]["rounds"];
  REQUIRE(rounds.size() >= 2);
  for (std::size_t i = 1; i < rounds.size(); ++i)
    CHECK(rounds[i]["energy"].get<double>() <= rounds[i - 1]["energy"].get<double>() * (1 + 1e-6));
  CHECK(rounds.back()["energy"] < free["frames"][1]["energy"]);
  CHECK(relinearized["frames"][1]["inverted"] == 0);
  // Too few rounds are no success.
  scene["manipulation"]["relinearize"] = 1;
  const Outcome run = manipulate({write_scene(scratch, scene), "-o", scratch.path("few"), "--no-picture"});
  CHECK(run.code == 5);
  CHECK(run.err.find("settled") != std::string::npos);
}

TEST_CASE(
    "manipulate: what is said of the unconstrained minimiser does not depend on rounds, and trouble in "
    "rounds loses nothing") {
  const Scratch scratch;
  const auto plain = solved(scratch, swirl(150));
  const auto rounds = solved(scratch, swirl(150), {"--relinearize", "200"}, "rounds");
  CHECK(rounds["frames"][1]["not_psd_before"] == plain["frames"][1]["not_psd_before"]);
  CHECK(rounds["frames"][1]["not_psd"] == 0);
  CHECK(rounds["frames"][1]["iterations"].get<int>() > plain["frames"][1]["iterations"].get<int>());
  // Hard handles that cannot be had, with bounded stretch: the penalty solution is written.
  Json scene = squashed_bar();
  for (auto& handle : scene["handles"]) handle["hard"] = true;
  scene["manipulation"]["largest_stretch"] = 1.5;
  scene["manipulation"]["relinearize"] = 2;
  const Outcome run = manipulate({write_scene(scratch, scene), "-o", scratch.path("hard"), "--no-picture"});
  CHECK(run.code == 6);
  CHECK(std::filesystem::exists(scratch.path("hard/frame_0001.vtu")));
  CHECK(read_json(scratch.path("hard/summary.json"))["frames"][1]["rounds"].size() == 2);
}

TEST_CASE("manipulate: energies that overflow end with code 6 and a summary, pictures or not") {
  const Scratch scratch;
  Json scene = swirl(30);
  scene["handles"][1]["translate"] = {0, -1e200};
  const Outcome run = manipulate({write_scene(scratch, scene), "-o", scratch.path("out")});
  CHECK(run.code == 6);
  CHECK(run.err.find("not finite") != std::string::npos);
  CHECK(std::filesystem::exists(scratch.path("out/summary.json")));
}

TEST_CASE("manipulate: all penalties of the published method meet at one energy") {
  const Scratch scratch;
  std::vector<double> energies;
  for (const std::string penalty : {"quadratic", "cubic", "spline"})
    energies.push_back(solved(scratch, swirl(150), {"--method", "penalty", "--penalty", penalty},
                              penalty)["frames"][1]["energy"]);
  CHECK(energies[1] == Approx(energies[0]).epsilon(2e-6));
  CHECK(energies[2] == Approx(energies[0]).epsilon(2e-6));
}

TEST_CASE(
    "manipulate: the unconstrained minimiser alone leaves inverted elements: exit code 6, and everything is "
    "written") {
  const Scratch scratch;
  const Outcome run = manipulate({write_scene(scratch, swirl(180)), "-o", scratch.path("out"), "--method",
                                  "unconstrained", "--no-picture"});
  CHECK(run.code == 6);
  CHECK(run.err.find("inverted element") != std::string::npos);
  CHECK(run.err.find("triangle") != std::string::npos);
  CHECK(read_json(scratch.path("out/summary.json"))["totals"]["frames_with_inverted"] == 1);
}

TEST_CASE("manipulate: too few iterations and no time are exit code 5 or 6, with the best state written") {
  const Scratch scratch;
  const std::string scene = write_scene(scratch, swirl(180, 8, 2));
  const Outcome few = manipulate(
      {scene, "-o", scratch.path("few"), "--max-iterations", "3", "--gap-tolerance", "1e-9", "--no-picture"});
  CHECK((few.code == 5 || few.code == 6));
  CHECK(read_json(scratch.path("few/summary.json"))["certified"] == false);
  const Outcome late =
      manipulate({scene, "-o", scratch.path("late"), "--time-limit", "1e-9", "--no-picture"});
  CHECK((late.code == 5 || late.code == 6));
  CHECK(late.err.find("--time-limit") != std::string::npos);
  const auto summary = read_json(scratch.path("late/summary.json"));
  CHECK(summary["outcome"] == "stopped");
  CHECK(summary["totals"]["frames_made"] == 1);
  CHECK(std::filesystem::exists(scratch.path("late/frame_0001.vtu")));
  CHECK(!std::filesystem::exists(scratch.path("late/frame_0002.vtu")));
}

TEST_CASE("manipulate: the scenes that come with it are certified, the quick ones of them") {
  const Scratch scratch;
  for (const char* name : {"arm", "yogurt180", "disc120", "bar_squash"}) {
    const std::string file =
        isostretch::tests::source_path("apps/isostretch-manipulate/scenes/" + std::string(name) + ".json");
    const Outcome run = manipulate({file, "-o", scratch.path(name), "--no-picture"});
    CHECK_MESSAGE(run.code == 0, name, ": ", run.err);
  }
}

// What a certificate and a converged solve do not say: whether handles are where they are wanted.
#include "deform_app.hpp"
#include "manipulate_app.hpp"

#include <isostretch/deformation/handle_misses.hpp>

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

using namespace isostretch;
using namespace isostretch::test;
using nlohmann::ordered_json;

namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ordered_json json_of(const std::string& file) {
  return ordered_json::parse(text_of(file));
}

std::string written(const Scratch& scratch, const ordered_json& scene) {
  const std::string file = scratch.path("scene.json");
  std::ofstream(file) << scene.dump();
  return file;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_SUITE("handles that miss") {
  TEST_CASE("a certified pose whose handle has collapsed says so") {
    const Scratch scratch;
    ordered_json scene = swirl(270, 14);
    scene["handles"][1]["select"]["sphere"]["radius"] = 0.08;
    const std::string out = scratch.path("out");
    const Outcome outcome = manipulate({written(scratch, scene), "--out", out});
    CHECK(outcome.code == 0);
    const ordered_json frame = json_of(out + "/summary.json")["frames"].back();
    CHECK(frame["certified"] == true);
    const ordered_json middle = frame["handles"][1];
    CHECK(middle["name"] == "middle");
    CHECK(middle["share_of_size"].get<double>() > 0.3);
    CHECK(middle["size_reached"].get<double>() < 0.5 * middle["size"].get<double>());
    CHECK(middle["mean"].get<double>() <= middle["largest"].get<double>());
    CHECK(frame["nearly_flat"]["count"].get<int>() > 0);
    CHECK(frame["nearly_flat"]["flattest"].size() <= 10);
    CHECK(contains(outcome.err, "warning: frame 1: handle 'middle' misses its targets by up to"));
    CHECK(contains(outcome.err, "it has shrunk to"));
    CHECK(contains(outcome.err, "are all but flat"));
    const std::string report = text_of(out + "/report.html");
    CHECK(contains(report, "largest miss"));
    CHECK(contains(report, "<td>alpha</td>"));  // the table of the problem has rows
    CHECK(contains(report, "class=\"player\""));
    CHECK_FALSE(contains(report, "src=\"http"));
  }

  TEST_CASE("a pose that is reached warns of nothing, and the last line says how far handles are off") {
    const Scratch scratch;
    const Outcome outcome =
        manipulate({written(scratch, swirl(20)), "--out", scratch.path("out"), "--no-picture"});
    CHECK(outcome.code == 0);
    CHECK_FALSE(contains(outcome.err, "warning"));
    CHECK(contains(outcome.out, "no element is inverted; handles miss their targets by "));
    CHECK(outcome.out.rfind("all frames are certified") > outcome.out.find("wrote "));
  }

  TEST_CASE("misses are lengths of the mesh and shares of a handle's size") {
    const Scratch scratch;
    const auto misses = [&](double size) {
      ordered_json scene = swirl(200);
      scene["mesh"]["grid"]["size"] = {size, size};
      scene["handles"][0]["select"]["patch"]["distance"] = 10 * size;
      scene["handles"][1]["select"]["sphere"] = {{"center", {0.5 * size, 0.5 * size}},
                                                 {"radius", 0.13 * size}};
      const std::string out = scratch.path("out" + std::to_string(size));
      manipulate({written(scratch, scene), "--out", out, "--no-picture"});
      return json_of(out + "/summary.json")["frames"].back()["handles"][1];
    };
    const ordered_json one = misses(1), thousand = misses(1000);
    CHECK(thousand["largest"].get<double>() ==
          doctest::Approx(1000 * one["largest"].get<double>()).epsilon(1e-4));
    CHECK(thousand["share_of_size"].get<double>() ==
          doctest::Approx(one["share_of_size"].get<double>()).epsilon(1e-4));
  }

  TEST_CASE("deform: a soft handle of one vertex that is left behind is measured, drawn and warned of") {
    const Scratch scratch;
    ordered_json scene = twisted_bar(10, 2);
    scene["handles"].push_back({{"name", "tip"},
                                {"select", {{"nearest", {{"point", {2, 1, 1}}}}}},
                                {"translate", {0, 1.5, 0}},
                                {"soft", 1e-6}});
    const std::string out = scratch.path("out");
    const Outcome outcome = deform({written(scratch, scene), "--out", out, "--glb"});
    CHECK(outcome.code == 0);
    const ordered_json frame = json_of(out + "/summary.json")["frames"].back();
    const ordered_json tip = frame["handles"][2];
    CHECK(tip["largest"].get<double>() > 1);
    CHECK(tip["share_of_size"].is_null());
    CHECK(frame["handles"][0]["largest"].get<double>() < 1e-12);
    CHECK(contains(outcome.err, "handle 'tip' misses its targets"));
    CHECK(text_of(out + "/deform.glb").substr(0, 4) == "glTF");
    CHECK(contains(text_of(out + "/report.html"), "class=\"player\""));
  }

  TEST_CASE("deform: --restart leaves the GLB of the whole run alone and says which frames its own has") {
    const Scratch scratch;
    const std::string scene = written(scratch, twisted_bar(20, 4)), out = scratch.path("out");
    CHECK(deform({scene, "--out", out, "--glb", "--no-picture"}).code == 0);
    const std::string whole = text_of(out + "/deform.glb");
    CHECK(deform({scene, "--out", out, "--glb", "--no-picture", "--restart"}).code == 0);
    CHECK(text_of(out + "/deform.glb") == whole);
    const std::string half = scratch.path("half");
    CHECK(deform({scene, "--out", half, "--no-picture", "--stop-after", "2"}).code == 5);
    const Outcome rest = deform({scene, "--out", half, "--glb", "--no-picture", "--restart"});
    CHECK(rest.code == 0);
    CHECK(contains(rest.err, "deform_0002_on.glb holds frames 2 to 4"));
    CHECK(text_of(half + "/deform_0002_on.glb").substr(0, 4) == "glTF");
  }
}

// The same bytes from isostretch-deform, whether a run stops and goes on or not, and on one thread and two.
#include "deform_app.hpp"
#include "deform_results.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>

using namespace isostretch::test;
using Json = nlohmann::ordered_json;

namespace {

void check_same_frames(const Scratch& scratch, const std::string& a, const std::string& b, int last) {
  for (int i = 0; i <= last; ++i) {
    char name[64];
    std::snprintf(name, sizeof name, "/frame_%04d.vtu", i);
    CHECK_MESSAGE(read_file(scratch.path(a + name)) == read_file(scratch.path(b + name)), name);
  }
}

}  // namespace

TEST_CASE("deform: a run that stops and goes on writes the same bytes as one that does not") {
  const Scratch scratch;
  const Json scene = twisted_bar(120, 6);
  solved(scratch, scene, {}, "whole");
  const std::string file = write_scene(scratch, scene), out = scratch.path("parts");
  const Outcome first = deform({file, "-o", out, "--no-picture", "--stop-after", "3"});
  CHECK(first.code == 5);
  CHECK(first.err.find("--stop-after") != std::string::npos);
  CHECK(!std::filesystem::exists(out + "/frame_0004.vtu"));
  CHECK(read_json(out + "/summary.json")["outcome"] == "stopped_by_stop_after");
  CHECK(read_json(out + "/summary.json")["frames_made"] == 3);
  CHECK(deform({file, "-o", out, "--no-picture", "--stop-after", "1", "--restart", "--threads", "1"}).code ==
        5);
  CHECK(std::filesystem::exists(out + "/frame_0004.vtu"));
  const Outcome second = deform({file, "-o", out, "--no-picture", "--restart"});
  CHECK_MESSAGE(second.code == 0, second.err);
  check_same_frames(scratch, "whole", "parts", 6);
  const auto a = read_json(scratch.path("whole/summary.json")), b = read_json(out + "/summary.json");
  CHECK(b["restarted_at"] == 5);
  for (std::size_t i = 1; i <= 6; ++i) CHECK(a["frames"][i]["energy"] == b["frames"][i]["energy"]);
  SUBCASE("a run that is finished has nothing left to do") {
    CHECK(deform({file, "-o", out, "--no-picture", "--restart"}).code == 0);
    check_same_frames(scratch, "whole", "parts", 6);
  }
  SUBCASE("another scene is refused, and the key named") {
    const Outcome other = deform({write_scene(scratch, twisted_bar(121, 6)), "-o", out, "--restart"});
    CHECK(other.code == 3);
    CHECK(other.err.find("'handles' has changed") != std::string::npos);
    write_scene(scratch, scene);
    const Outcome solver = deform({file, "-o", out, "--restart", "--projection", "clamp"});
    CHECK(solver.err.find("'newton' has changed") != std::string::npos);
  }
  SUBCASE("a state that is damaged is refused") {
    scratch.write("parts/restart.json", "{\"scene\": {}, ");
    CHECK(deform({file, "-o", out, "--restart"}).code == 3);
  }
}

TEST_CASE("deform: Ctrl-C ends after the iteration, and --restart goes on to the same bytes") {
  const Scratch scratch;
  Json scene = twisted_bar(200, 8);
  scene["mesh"]["bar"]["cells"] = {24, 6, 6};
  const std::string file = write_scene(scratch, scene), out = scratch.path("parts");
  const Outcome first = deform({file, "-o", out, "--no-picture"}, [&](int process) {
    for (int i = 0; i < 20000 && !std::filesystem::exists(out + "/frame_0002.vtu"); ++i)
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    ::kill(process, SIGINT);
  });
  CHECK_MESSAGE(first.code == 5, first.err);
  CHECK(first.err.find("interrupted") != std::string::npos);
  CHECK(read_json(out + "/summary.json")["outcome"] == "stopped");
  CHECK(deform({file, "-o", out, "--no-picture", "--restart"}).code == 0);
  solved(scratch, scene, {}, "whole");
  check_same_frames(scratch, "whole", "parts", 8);
}

TEST_CASE("deform: one thread and two write the same bytes") {
  const Scratch scratch;
  solved(scratch, twisted_bar(60, 2), {"--threads", "1"}, "one");
  solved(scratch, twisted_bar(60, 2), {"--threads", "2"}, "two");
  check_same_frames(scratch, "one", "two", 2);
}

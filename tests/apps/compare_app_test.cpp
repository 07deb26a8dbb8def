// isostretch-compare from its command line to its files.
#include "compare_app.hpp"

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;
using Json = nlohmann::ordered_json;

namespace {

nlohmann::json method_of(const nlohmann::json& problem, const std::string& name) {
  for (const auto& method : problem["methods"])
    if (method["method"] == name) return method;
  FAIL("there is no ", name);
  return {};
}

const char* const errors[] = {"1e-01", "1e-02", "1e-03", "1e-04", "1e-05",
                              "1e-06", "1e-07", "1e-08", "1e-09"};

// Errors that are harder to reach are not reached sooner.
void check_times(const nlohmann::json& run) {
  double before = 0;
  for (const char* error : errors) {
    const auto& seconds = run["seconds_to_" + std::string(error)];
    const double now = seconds.is_null() ? HUGE_VAL : seconds.get<double>();
    CHECK(now >= before);
    before = now;
  }
}

// Every element that is opened is closed, in order.
bool is_well_formed(const std::string& page) {
  const std::vector<std::string> alone{"meta", "img", "!DOCTYPE", "?xml"};
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return false;
    const bool closes = page[at + 1] == '/';
    const std::string tag = page.substr(at + (closes ? 2 : 1), end - at - (closes ? 2 : 1));
    const std::string name = tag.substr(0, tag.find_first_of(" \n/"));
    if (closes && (open.empty() || open.back() != name)) return false;
    if (closes)
      open.pop_back();
    else if (std::find(alone.begin(), alone.end(), name) == alone.end() && tag.back() != '/')
      open.push_back(name);
  }
  return open.empty();
}

std::filesystem::file_time_type made(const Scratch& scratch, const std::string& run) {
  return std::filesystem::last_write_time(scratch.path("out/runs/" + run + "/summary.json"));
}

}  // namespace

TEST_CASE("compare: methods on a face and a bar, with one optimum each, tables, plots, profiles and a page") {
  const Scratch scratch;
  const Json scene = comparison_scene({face_problem(), bar_problem("symmetric_dirichlet")},
                                      {"isostretch", "analytic", "newton"}, 2);
  const std::vector<std::string> command{
      "--scene", write_scene(scratch, scene), "-o", scratch.path("out"), "--threads", "1"};
  const Outcome run = compare(command);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run.out.find("12 of 12 runs compared") != std::string::npos);
  CHECK(run.out.find("face: relative error 1e-03: ") != std::string::npos);

  const auto comparison = read_json(scratch.path("out/comparison.json"));
  CHECK(comparison["machine"]["threads"] == 1);
  CHECK(comparison["machine"]["cores"].get<int>() > 0);
  CHECK(comparison["default"] == "isostretch");
  REQUIRE(comparison["problems"].size() == 2);
  for (const auto& problem : comparison["problems"]) {
    const double optimum = problem["optimum"];
    CHECK(problem["optimum_polished"] == true);
    CHECK(problem["other_minima"].empty());
    CHECK(problem["benchmarks"].size() == 4);
    REQUIRE(problem["methods"].size() == 3);
    for (const auto& method : problem["methods"]) {
      CHECK(method["status"] == "converged_gradient");
      CHECK(method["flips"] == 0);
      CHECK(method["iterations"].get<int>() > 0);
      CHECK(method["seconds_least"].get<double>() <= method["seconds_median"].get<double>());
      CHECK(method["seconds_median"].get<double>() <= method["seconds_most"].get<double>());
      CHECK(method["peak_megabytes_median"].get<double>() > 1);
      CHECK(method["ms_per_iteration_total"].get<double>() >=
            method["ms_per_iteration_assembly"].get<double>());
      REQUIRE(method["runs"].size() == 2);
      for (const auto& r : method["runs"]) {
        CHECK(optimum <= r["energy"].get<double>());
        CHECK(r["relative_error"].get<double>() < 1e-6);
        CHECK(r["gradient_inf_norm"].get<double>() <= 1e-4);
        CHECK_FALSE(r["seconds_to_1e-06"].is_null());
        CHECK_FALSE(r["seconds_to_gradient_tolerance"].is_null());
        check_times(r);
        for (const char* file : {"trace.csv", "positions.bin", "summary.json", "run.txt"})
          CHECK_MESSAGE(
              std::filesystem::exists(scratch.path("out/" + r["folder"].get<std::string>() + "/" + file)),
              file);
      }
    }
  }
  REQUIRE(comparison["profiles"].size() == 4);
  for (const auto& curve : comparison["profiles"][0]["methods"])
    for (const auto& factor : curve["factors"]) CHECK(factor.get<double>() >= 1);

  for (const char* name : {"face", "bar_symmetric_dirichlet", "profiles"}) {
    CHECK(read_file(scratch.path(std::string("out/") + name + ".png")).rfind("\x89PNG", 0) == 0);
    const std::string svg = read_file(scratch.path(std::string("out/") + name + ".svg"));
    CHECK(svg.find("<svg") != std::string::npos);
    CHECK(is_well_formed(svg));
  }
  const std::string page = read_file(scratch.path("out/report.html"));
  CHECK(is_well_formed(page));
  CHECK(page.find("http") == std::string::npos);
  for (const char* words : {"Performance profiles", "analytic", "Every method converged", "processor"})
    CHECK_MESSAGE(page.find(words) != std::string::npos, words);
  const std::string runs = read_file(scratch.path("out/runs.csv"));
  CHECK(runs.rfind("problem,method,repetition,status,converged,iterations,factorizations,seconds,energy",
                   0) == 0);
  CHECK(std::count(runs.begin(), runs.end(), '\n') == 13);
  const std::string methods = read_file(scratch.path("out/methods.csv"));
  CHECK(std::count(methods.begin(), methods.end(), '\n') == 7);
  CHECK(methods.find("seconds_to_1e-09_median") != std::string::npos);

  // What is there is not made again; of another number of threads it is.
  const auto first = made(scratch, "face/newton/1"), before = made(scratch, "face/newton/2");
  REQUIRE(compare(command).code == 0);
  CHECK(made(scratch, "face/newton/2") == before);
  CHECK(read_json(scratch.path("out/comparison.json"))["problems"] == comparison["problems"]);
  std::vector<std::string> other = command;
  other.back() = "2";
  other.insert(other.end(), {"--no-picture", "--repetitions", "1"});
  REQUIRE(compare(other).code == 0);
  const auto again = read_json(scratch.path("out/comparison.json"));
  CHECK(again["machine"]["threads"] == 2);
  CHECK(made(scratch, "face/newton/1") != first);
  CHECK(made(scratch, "face/newton/2") == before);
  // No result depends on the number of threads.
  for (std::size_t p = 0; p < 2; ++p)
    CHECK(method_of(again["problems"][p], "newton")["energy"] ==
          method_of(comparison["problems"][p], "newton")["energy"]);
}

TEST_CASE(
    "compare: a mesh and energies from the command line; methods that are not applicable and failures are "
    "named") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("my face.obj"), mesh::procedural_face(6));
  const Outcome run =
      compare({scratch.path("my face.obj"), "-e", "symmetric_dirichlet,arap", "-m", "all", "--repetitions",
               "1", "--max-iterations", "3", "--no-picture", "-o", scratch.path("out")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto comparison = read_json(scratch.path("out/comparison.json"));
  REQUIRE(comparison["problems"].size() == 2);
  CHECK(comparison["problems"][0]["name"] == "my_face_symmetric_dirichlet");
  CHECK(comparison["problems"][1]["facts"]["energy"] == "arap");
  const std::string page = read_file(scratch.path("out/report.html"));
  CHECK(page.find("stopped_iterations") != std::string::npos);
  const auto surface = mesh::procedural_face(6);
  for (std::size_t p = 0; p < 2; ++p) {
    const auto& problem = comparison["problems"][p];
    CHECK(problem["methods"].size() == baselines::methods().size());
    const std::string energy = problem["facts"]["energy"];
    const baselines::DistortionProblem distortion{
        assembly::elements_from(mesh::flat_elements(surface)), energies::make_energy(energy), {}};
    for (const auto& info : baselines::methods()) {
      const auto method = method_of(problem, std::string(info.name));
      const std::string reason = baselines::why_not_applicable(info.name, distortion);
      CAPTURE(info.name);
      CHECK((method["status"] == "not_applicable") == !reason.empty());
      if (reason.empty()) continue;
      CHECK(method["message"] == reason);
      CHECK(method["runs"].empty());
      CHECK(page.find("not run: not applicable") != std::string::npos);
    }
  }
}

TEST_CASE("compare: a method that has no time is named with its reason") {
  const Scratch scratch;
  const Outcome run =
      compare({"--scene", write_scene(scratch, comparison_scene({face_problem(30)}, {"newton"})),
               "--time-limit", "0.001", "-o", scratch.path("out")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto problem = read_json(scratch.path("out/comparison.json"))["problems"][0];
  const auto method = method_of(problem, "newton");
  CHECK(method["status"] == "stopped_time");
  CHECK(method["seconds_to_1e-03_median"].is_null());
  // The optimum is polished from where it stopped, by the default.
  CHECK(problem["optimum"].get<double>() < method["energy"].get<double>());
  const std::string page = read_file(scratch.path("out/report.html"));
  CHECK(page.find("<td>newton</td><td>stopped time</td>") != std::string::npos);
  CHECK(page.find("nobody gets there") != std::string::npos);
}

TEST_CASE("compare: bodies with barriers, kinks and inverted elements, in space and in the plane") {
  const Scratch scratch;
  Json square = bar_problem("arap");
  square["name"] = "square";
  square["mesh"] = {{"bar", {{"cells", {4, 4}}, {"element", "quad"}}}};
  square["handles"][1]["rotate"] = {{"degrees", 30}};
  Json hexes = bar_problem("stable_neo_hookean");
  hexes["mesh"]["bar"]["element"] = "hex";
  hexes["material"] = {{"young", 1}, {"poisson", 0.4}};
  const Json scene =
      comparison_scene({bar_problem("symmetric_dirichlet", 100), bar_problem("arap", 150), hexes, square},
                       {"isostretch", "analytic"});
  const Outcome run =
      compare({"--scene", write_scene(scratch, scene), "--no-picture", "-o", scratch.path("out")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto comparison = read_json(scratch.path("out/comparison.json"));
  for (const auto& problem : comparison["problems"]) {
    CAPTURE(problem["name"]);
    CHECK(problem["facts"]["pinned"].get<int>() > 0);
    for (const auto& method : problem["methods"]) CHECK(method["status"] == "converged_gradient");
  }
}

TEST_CASE("compare: one run by itself, as the program calls itself") {
  const Scratch scratch;
  const std::string scene = write_scene(scratch, comparison_scene({face_problem()}, {"isostretch"}));
  Outcome run = compare({"--scene", scene, "--run", "face", "-m", "newton", "-o", scratch.path("first")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto summary = read_json(scratch.path("first/summary.json"));
  CHECK(summary["method"] == "newton");
  const std::string trace = read_file(scratch.path("first/trace.csv"));
  CHECK(trace.rfind("iteration,seconds,energy,gradient_inf_norm,step,", 0) == 0);
  CHECK(std::count(trace.begin(), trace.end(), '\n') == summary["iterations"].get<long>() + 2);
  run = compare({"--scene", scene, "--run", "face", "-m", "isostretch", "--from",
                 scratch.path("first/positions.bin"), "--gradient-tolerance", "0", "-o",
                 scratch.path("second")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto polished = read_json(scratch.path("second/summary.json"));
  CHECK(polished["status"] == "converged_roundoff");
  CHECK(polished["initial_energy"] == summary["energy"]);
  CHECK(polished["energy"].get<double>() <= summary["energy"].get<double>());

  check_failure(scratch, {"--scene", scene, "--run", "nose", "-m", "newton", "-o", scratch.path("out")}, 2,
                {"--run: there is no problem 'nose'; there are face"});
  check_failure(scratch, {"--scene", scene, "--run", "face", "-m", "all", "-o", scratch.path("out")}, 2,
                {"--run: takes one --method"});
  check_failure(
      scratch,
      {"--scene", scene, "--run", "face", "-m", "newton", "--from", scene, "-o", scratch.path("out")}, 3,
      {"scene.json: must hold "});
  run = compare({"--scene", scene, "--run", "face", "-m", "newton", "--max-iterations", "1", "-o",
                 scratch.path("third")});
  CHECK(run.code == 5);
}

TEST_CASE("compare: Ctrl-C during energies ends the run there is, and the same command goes on") {
  const Scratch scratch;
  // The second one takes its time and is stopped in the middle.
  Json large = face_problem(150);
  large["name"] = "large";
  const std::vector<std::string> command{
      "--scene", write_scene(scratch, comparison_scene({face_problem(), large}, {"analytic"})),
      "--no-picture", "-o", scratch.path("out")};
  const Outcome run = compare(command, [&](int process) {
    const auto begun = [&] {
      return std::filesystem::exists(scratch.path("out/runs/large/analytic/1/log.txt"));
    };
    for (int i = 0; i < 1200 && !begun(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(process, SIGINT);
  });
  CHECK(run.code == 5);
  CHECK(run.err.find("1 of 2 runs compared, interrupted (Ctrl-C); the same command goes on") !=
        std::string::npos);
  const auto comparison = read_json(scratch.path("out/comparison.json"));
  CHECK(comparison["problems"][0]["methods"][0]["runs"].size() == 1);
  CHECK(comparison["problems"][0]["optimum"].is_number());
  CHECK(comparison["problems"][0]["optimum_polished"] == false);
  CHECK(comparison["problems"][1]["methods"][0]["runs"].empty());
  const auto before = made(scratch, "face/analytic/1");
  const Outcome rest = compare(command);
  REQUIRE_MESSAGE(rest.code == 0, rest.err);
  CHECK(made(scratch, "face/analytic/1") == before);
  CHECK(read_json(scratch.path("out/comparison.json"))["problems"][1]["methods"][0]["status"] ==
        "converged_gradient");
}

TEST_CASE("compare: a mesh that has changed behind its name, and results that were cut off, are made again") {
  const Scratch scratch;
  const std::vector<std::string> command{scratch.path("face.obj"), "-m",          "isostretch",
                                         "--repetitions",          "1",           "-o",
                                         scratch.path("out"),      "--no-picture"};
  const auto optimum = [&] {
    const Outcome run = compare(command);
    REQUIRE_MESSAGE(run.code == 0, run.err);
    return read_json(scratch.path("out/comparison.json"))["problems"][0]["optimum"].get<double>();
  };
  mesh::write_obj(scratch.path("face.obj"), mesh::procedural_face(5));
  const double before = optimum();
  std::ofstream(scratch.path("out/runs/face_symmetric_dirichlet/isostretch/1/summary.json"))
      << "{\"status\": ";
  CHECK(optimum() == before);
  mesh::write_obj(scratch.path("face.obj"), mesh::procedural_face(6));
  CHECK(optimum() != before);
}

TEST_CASE("compare: --help lists the options, --list-methods and --list-energies what there is") {
  CHECK(compare({"--help"}).out.find("--scene") != std::string::npos);
  const Outcome methods = compare({"--list-methods"});
  CHECK(methods.code == 0);
  for (const auto& info : baselines::methods())
    CHECK(methods.out.find(std::string(info.name) + "  ") != std::string::npos);
  CHECK(compare({"--list-energies"}).out.find("stable_neo_hookean") != std::string::npos);
}

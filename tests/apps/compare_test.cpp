// Rivals by isostretch-manipulate: one with --rival, many with --compare.
#include "manipulate_app.hpp"

#include <doctest/doctest.h>

#include <csignal>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

using namespace isostretch::test;
using Json = nlohmann::ordered_json;

namespace {

nlohmann::json candidate(const nlohmann::json& comparison, const std::string& solver) {
  for (const auto& entry : comparison["solvers"])
    if (entry["solver"] == solver) return entry;
  FAIL("there is no ", solver);
  return {};
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

// A rectangle of 4 x 4 squares, each in two triangles, so wide.
std::string rectangle(double width) {
  std::string text;
  for (int i = 0; i < 25; ++i)
    text += "v " + std::to_string(0.25 * width * (i % 5)) + ' ' + std::to_string(0.25 * (i / 5)) + " 0\n";
  for (int i = 1; i < 20; ++i)
    if (i % 5 != 0) {
      const std::string a = std::to_string(i) + ' ', b = std::to_string(i + 6) + ' ';
      text += "f " + a + std::to_string(i + 1) + ' ' + b + "\nf " + a + b + std::to_string(i + 5) + '\n';
    }
  return text;
}

}  // namespace

TEST_CASE("solver: a rival makes the frames, and the summary has its account") {
  const Scratch scratch;
  const Outcome run = manipulate(
      {write_scene(scratch, swirl(180)), "--rival", "locally_injective", "-o", scratch.path("out")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto summary = read_json(scratch.path("out/summary.json"));
  CHECK(summary["method"] == "locally_injective");
  CHECK(summary["certified"] == false);
  const auto& f = summary["frames"][1];
  CHECK(f["status"] == "converged");
  CHECK(f["reached"] == true);
  CHECK(f["inverted"] == 0);
  CHECK(f["inverted_before"].get<int>() > 0);
  CHECK(f["distortion"].get<double>() < f["elastic_energy"].get<double>());
  CHECK(f["solver_seconds"]["solving"].get<double>() > 0);
  const std::string trace = read_file(scratch.path("out/trace.csv"));
  CHECK(first_line(trace) ==
        "frame,iteration,seconds,energy,min_eigenvalue,min_det_F,distortion,inverted,infeasible");
  CHECK(std::count(trace.begin(), trace.end(), '\n') == f["iterations"].get<long>() + 2);
  for (const char* file : {"frame_0001.vtu", "manipulate.png", "path.png", "report.html"})
    CHECK_MESSAGE(std::filesystem::exists(scratch.path(std::string("out/") + file)), file);
}

TEST_CASE("solver: one that is none for the instance fails the frame by its own words") {
  const Scratch scratch;
  const Outcome run = manipulate(
      {write_scene(scratch, squashed_bar()), "--rival", "lifted_content", "-o", scratch.path("out")});
  CHECK(run.code == 6);
  CHECK(run.err.find("it needs a target at every node of the boundary") != std::string::npos);
  CHECK(read_json(scratch.path("out/summary.json"))["frames"][1]["status"] == "not_applicable");
}

#if !defined(__SANITIZE_ADDRESS__)  // which takes more address space than there is
TEST_CASE("solver: more memory than is allowed is a status, and the rest is written") {
  const Scratch scratch;
  for (const char* solver : {"interior_point", "penalty"}) {
    const Outcome run = manipulate({write_scene(scratch, swirl(180, 200)), "--rival", solver,
                                    "--memory-limit", "60", "--no-picture", "-o", scratch.path("out")});
    CAPTURE(run.err);
    CHECK(run.code == 6);
    CHECK(read_json(scratch.path("out/summary.json"))["frames"][1]["status"] == "memory_limit");
  }
}
#endif

TEST_CASE("solver: what does not go with it, and names there are not") {
  const Scratch scratch;
  Json scene = swirl(90);
  scene["rival"] = "mosek";
  Outcome run = manipulate({write_scene(scratch, scene), "-o", scratch.path("out")});
  CHECK(run.code == 3);
  CHECK(run.err.find("rival: must be one of interior_point") != std::string::npos);
  scene["rival"] = "penalty";
  scene["manipulation"]["relinearize"] = 3;
  run = manipulate({write_scene(scratch, scene), "-o", scratch.path("out")});
  CHECK(run.code == 3);
  CHECK(run.err.find("relinearize: does not go with a rival") != std::string::npos);
  run = manipulate({write_scene(scratch, swirl(90)), "--rival", "mosek", "-o", scratch.path("out")});
  CHECK(run.code == 2);
  run =
      manipulate({write_scene(scratch, swirl(90)), "--compare", "penalty,mosek", "-o", scratch.path("out")});
  CHECK(run.code == 2);
  CHECK(run.err.find("there is no solver 'mosek'; there are all, convex, alternative, interior_point") !=
        std::string::npos);
  CHECK_FALSE(std::filesystem::exists(scratch.path("out")));
}

TEST_CASE("compare: a wrong scene is refused by its own name before anything is written") {
  const Scratch scratch;
  Json scene = swirl(90);
  scene["manipulation"]["alpha"] = "much";
  const Outcome run =
      manipulate({write_scene(scratch, scene), "--compare", "penalty", "-o", scratch.path("out")});
  CHECK(run.code == 3);
  CHECK(run.err.find("scene.json: manipulation.alpha: ") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(scratch.path("out")));
}

TEST_CASE("compare: every solver in a process of its own, one optimum, a table, plots, and a page") {
  const Scratch scratch;
  const std::vector<std::string> command{write_scene(scratch, swirl(180)),
                                         "--compare",
                                         "interior_point,penalty,foldover_free",
                                         "--repetitions",
                                         "3",
                                         "--time-limit",
                                         "60",
                                         "-o",
                                         scratch.path("out")};
  const Outcome run = manipulate(command);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  for (const char* file :
       {"comparison.png", "comparison.csv", "comparison.json", "comparison.html", "scene.json",
        "runs/penalty/trace.csv", "runs/penalty_3/summary.json", "runs/optimum/summary.json"})
    CHECK_MESSAGE(std::filesystem::exists(scratch.path(std::string("out/") + file)), file);
  const auto comparison = read_json(scratch.path("out/comparison.json"));
  const double optimum = comparison["optimum"];
  CHECK(comparison["lower_bound"].get<double>() <= optimum);
  for (const char* solver : {"interior_point", "penalty"}) {
    const auto entry = candidate(comparison, solver);
    CHECK(entry["status"] == "converged");
    CHECK(entry["kind"] == "convex");
    CHECK(entry["relative_error"].get<double>() < 2e-6);
    CHECK(entry["inverted"] == 0);
    CHECK(entry["peak_megabytes"].get<double>() > 1);
    CHECK(entry["least_seconds"].get<double>() <= entry["seconds"].get<double>());
    CHECK(entry["seconds"].get<double>() <= entry["most_seconds"].get<double>());
  }
  const auto foldover_free = candidate(comparison, "foldover_free");
  CHECK(foldover_free["kind"] == "alternative");
  CHECK(foldover_free["relative_error"].is_null());
  CHECK(foldover_free["inverted"] == 0);
  // What is there is not made again, and what depends on something else is.
  const auto written = [&] {
    return std::filesystem::last_write_time(scratch.path("out/runs/penalty/summary.json"));
  };
  const auto before = written();
  CHECK(manipulate(command).code == 0);
  CHECK(written() == before);
  CHECK(read_json(scratch.path("out/comparison.json")) == comparison);
  std::vector<std::string> other = command;
  other[6] = "50";
  CHECK(manipulate(other).code == 0);
  CHECK(written() != before);
}

TEST_CASE("compare: Ctrl-C during solvers ends the run there is, and the same command goes on") {
  const Scratch scratch;
  const std::vector<std::string> command{write_scene(scratch, swirl(180, 60)),
                                         "--compare",
                                         "interior_point,penalty_published,penalty",
                                         "--no-picture",
                                         "-o",
                                         scratch.path("out")};
  const Outcome run = manipulate(command, [&](int process) {
    const auto begun = [&] { return std::filesystem::exists(scratch.path("out/runs/penalty_published")); };
    for (int i = 0; i < 1200 && !begun(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ::kill(process, SIGINT);
  });
  CHECK(run.code == 5);
  CHECK(run.err.find("the same command goes on") != std::string::npos);
  const auto comparison = read_json(scratch.path("out/comparison.json"));
  CHECK(candidate(comparison, "interior_point")["status"] == "converged");
  CHECK(candidate(comparison, "penalty_published")["status"] == "callback");
  CHECK(comparison["solvers"].size() == 2);
  std::vector<std::string> rest = command;
  rest.insert(rest.end(), {"--time-limit", "1"});
  const Outcome again = manipulate(rest);
  REQUIRE_MESSAGE(again.code == 0, again.err);
  CHECK(read_json(scratch.path("out/comparison.json"))["solvers"].size() == 3);
}

TEST_CASE("compare: without a feasible position there is no optimum, and no error is told") {
  const Scratch scratch;
  Json scene = swirl(180);
  for (auto& handle : scene["handles"]) handle["hard"] = true;
  scene["handles"][1]["select"]["sphere"]["radius"] = 0.3;
  const Outcome run = manipulate(
      {write_scene(scratch, scene), "--compare", "interior_point,foldover_free", "-o", scratch.path("out")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run.err.find("the optimum is not known (claims_infeasible") != std::string::npos);
  const auto comparison = read_json(scratch.path("out/comparison.json"));
  CHECK(comparison["optimum"].is_null());
  CHECK(candidate(comparison, "interior_point")["status"] == "claims_infeasible");
  CHECK(candidate(comparison, "interior_point")["relative_error"].is_null());
}

TEST_CASE("compare: flags that choose a method are refused beside it") {
  const Scratch scratch;
  for (const char* flag : {"--rival=penalty", "--method=penalty", "--relinearize=2"})
    CHECK(
        manipulate({write_scene(scratch, swirl(90)), "--compare", "penalty", flag, "-o", scratch.path("out")})
            .code == 2);
  CHECK(manipulate({write_scene(scratch, swirl(90)), "--repetitions", "2", "-o", scratch.path("out")}).code ==
        2);
}

TEST_CASE("compare: a run that hits its limit is shown as that") {
  const Scratch scratch;
  const Outcome run =
      manipulate({write_scene(scratch, swirl(180, 40)), "--compare", "interior_point,penalty_published",
                  "--time-limit", "0.05", "--no-picture", "-o", scratch.path("out")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto entry = candidate(read_json(scratch.path("out/comparison.json")), "penalty_published");
  CHECK(entry["status"] == "time_limit");
}

TEST_CASE("compare: a mesh that has changed behind its name is another one") {
  const Scratch scratch;
  scratch.write("body.obj", rectangle(1));
  const std::vector<std::string> command{scratch.path("body.obj"),
                                         "--handle",
                                         "slab:x,min,0.01",
                                         "--handle",
                                         "slab:x,max,0.01;translate=-1.2,0.3",
                                         "--compare",
                                         "penalty",
                                         "--no-picture",
                                         "-o",
                                         scratch.path("out")};
  Outcome run = manipulate(command);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const double before = read_json(scratch.path("out/comparison.json"))["optimum"];
  scratch.write("body.obj", rectangle(1.5));
  run = manipulate(command);
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto comparison = read_json(scratch.path("out/comparison.json"));
  CHECK(comparison["optimum"].get<double>() != before);
  CHECK(candidate(comparison, "penalty")["relative_error"].get<double>() < 2e-6);
}

TEST_CASE("compare: at rest the optimum is 0, and so are the errors") {
  const Scratch scratch;
  const Outcome run = manipulate({write_scene(scratch, swirl(0)), "--compare", "interior_point,penalty",
                                  "--no-picture", "-o", scratch.path("out")});
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const auto comparison = read_json(scratch.path("out/comparison.json"));
  for (const char* solver : {"interior_point", "penalty"})
    CHECK(candidate(comparison, solver)["relative_error"].get<double>() < 1e-6);
}

TEST_CASE("compare: results that were cut off are made again") {
  const Scratch scratch;
  const std::vector<std::string> command{
      write_scene(scratch, swirl(90)), "--compare", "penalty", "--no-picture", "-o", scratch.path("out")};
  REQUIRE(manipulate(command).code == 0);
  std::ofstream(scratch.path("out/runs/penalty/summary.json")) << "{\"frames\": [";
  REQUIRE(manipulate(command).code == 0);
  CHECK(candidate(read_json(scratch.path("out/comparison.json")), "penalty")["status"] == "converged");
}

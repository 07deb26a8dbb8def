#include "compare.hpp"

#include "common/interrupt.hpp"
#include "common/results.hpp"
#include "common/scene_input.hpp"
#include "common/terminal.hpp"
#include "common/threads.hpp"

#include <isostretch/comparison/machine.hpp>
#include <isostretch/comparison/method_optimum.hpp>
#include <isostretch/comparison/method_page.hpp>
#include <isostretch/comparison/method_tables.hpp>
#include <isostretch/comparison/method_verdicts.hpp>
#include <isostretch/core/text.hpp>

namespace isostretch::app::compare {
namespace {

namespace fs = std::filesystem;
using comparison::ComparedProblem;
using comparison::MethodCandidate;
using comparison::MethodRun;

class Benchmark {
 public:
  Benchmark(const CommandLine& command_line, const CommonOptions& common)
      : common_(common), scene_(command_line.scene()), options_(command_line.options(scene_)) {
    comparison_.settings = options_;
    read_problems(command_line.scene_file());
    comparison_.machine = comparison::machine_record(thread_count());
    runs_ = {
        .scene_file = options_.out / "scene.json",
        .out = options_.out,
        .limits = options_.limits,
        .threads = common.threads,
        .plugins = common.plugins,
        .environment = "threads " + std::to_string(thread_count()) + "\n" + comparison_.machine.to_json(),
        .stop = interrupt_token()};
  }

  ExitCode run() {
    OutputFolder folder(options_.out);
    folder.write_now("scene.json", scene::to_json(scene_, 2) + "\n");
    comparison_.date = comparison::date_text();
    for (int number = 1; number <= options_.repetitions; ++number) run_repetition(number);
    for (ComparedProblem& problem : comparison_.problems)
      comparison::find_optimum(problem, runs_, [&] { show_progress(problem.name + ": the optimum"); });
    clear_progress();
    write(folder);
    return conclude(folder);
  }

 private:
  // As the runs will: what is wrong is to be said once, of the files that the user knows, before anything is
  // run or written.
  void read_problems(const fs::path& scene_file) {
    reading_scene(scene_file, [&] {
      for (const scene::Node& value : comparison::read_problem_list(scene_))
        add_problem(comparison::read_problem(value, scene_folder(scene_file), warn), value);
    });
    for (scene::Value& problem : scene_["problems"].items())
      name_file_from_anywhere(problem["mesh"], scene_file);
  }

  void add_problem(const comparison::Problem& problem, const scene::Node& value) {
    comparison_.problems.push_back(comparison::compared_problem(problem, value.value(), options_.methods));
    for (const MethodCandidate& candidate : comparison_.problems.back().candidates)
      if (!candidate.why_not_applicable.empty())
        notice(problem.name + ": " + std::string(candidate.info.name) +
               " is not run: " + candidate.why_not_applicable);
  }

  // The scene is written to another folder.
  static void name_file_from_anywhere(scene::Value& mesh, const fs::path& scene_file) {
    if (mesh.is_text()) mesh = fs::absolute(scene_folder(scene_file) / mesh.text()).string();
  }

  // Repetitions are outermost: what else the machine does for a while strikes all methods alike.
  void run_repetition(int number) {
    for (ComparedProblem& problem : comparison_.problems)
      for (MethodCandidate& candidate : problem.candidates) {
        if (interrupted()) return;
        if (candidate.why_not_applicable.empty()) run_once(problem, candidate, number);
      }
  }

  void run_once(const ComparedProblem& problem, MethodCandidate& candidate, int number) {
    const std::string method(candidate.info.name);
    const std::string what =
        problem.name + ": " + method + formatted(", repetition %d of %d", number, options_.repetitions);
    show_progress(formatted("run %d of %d  ", ++begun_, comparison_.wanted_runs()) + what);
    const MethodRun run = runs_.repetition(problem, method, number);
    if (interrupted()) return;  // the next time it is made again, or found whole
    candidate.runs.push_back(run);
    notice(what + ": " + run.status + formatted(", %.3g s, energy %.10g", run.seconds, run.energy()) +
           (run.has_summary() ? "" : ": " + run.message));
  }

  void write(OutputFolder& folder) const {
    folder.add("comparison.json", comparison::comparison_json(comparison_));
    folder.add("runs.csv", comparison::run_table(comparison_));
    folder.add("methods.csv", comparison::method_table(comparison_));
    std::vector<comparison::NamedPicture> pictures;
    if (options_.picture) pictures = comparison::draw_all(comparison_);
    for (const comparison::NamedPicture& picture : pictures) {
      folder.add(picture.name + ".png", picture.png);
      folder.add(picture.name + ".svg", picture.svg);
    }
    folder.add("report.html", comparison::comparison_page(comparison_, pictures));
    folder.commit();
  }

  ExitCode conclude(const OutputFolder& folder) const {
    for (const ComparedProblem& problem : comparison_.problems) {
      for (const std::string& line : comparison::verdicts(problem, options_.limits))
        print(problem.name + ": " + line + "\n");
      for (const std::string& line : comparison::reservations(problem, options_.limits))
        warn(problem.name + ": " + line);
    }
    const bool whole = !interrupted();
    return app::conclude(
        formatted("%d of %d runs compared", comparison_.made_runs(), comparison_.wanted_runs()) +
            (whole ? "" : ", interrupted (Ctrl-C); the same command goes on"),
        whole ? ExitCode::success : ExitCode::not_converged, folder, options_.out, common_.verbose);
  }

  const CommonOptions& common_;
  scene::Value scene_;
  Options options_;
  comparison::MethodComparison comparison_;
  comparison::MethodRuns runs_;
  int begun_ = 0;
};

}  // namespace

ExitCode compare(const CommandLine& command_line, const CommonOptions& common) {
  return Benchmark(command_line, common).run();
}

}  // namespace isostretch::app::compare

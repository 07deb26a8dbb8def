#include "compare.hpp"

#include "common/interrupt.hpp"
#include "common/machine.hpp"
#include "common/scene_input.hpp"
#include "common/sequence_report.hpp"
#include "common/terminal.hpp"
#include "comparison.hpp"
#include "plots.hpp"
#include "problem.hpp"
#include "report_page.hpp"
#include "runs.hpp"
#include "scene_reader.hpp"
#include "tables.hpp"
#include "verdicts.hpp"

#include <isostretch/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::app::compare {
namespace {

namespace fs = std::filesystem;

class Benchmark {
 public:
  Benchmark(const CommandLine& command_line, const CommonOptions& common)
      : common_(common), scene_(command_line.scene()) {
    comparison_.options = command_line.options(scene_);
    read_problems(command_line.scene_file());
    const Options& options = comparison_.options;
    runs_ = {options.out / "scene.json", options.out, options.limits, common.threads, common.plugins};
  }

  ExitCode run() {
    OutputFolder folder(comparison_.options.out);
    folder.write_now("scene.json", scene::to_json(scene_, 2) + "\n");
    comparison_.date = date_text();
    comparison_.machine = machine_json();
    for (int number = 1; number <= comparison_.options.repetitions; ++number) run_repetition(number);
    for (std::size_t p = 0; p < comparison_.problems.size(); ++p) find_optimum(p);
    clear_progress();
    write(folder);
    return conclude(folder);
  }

 private:
  // As the runs will: what is wrong is to be said once, of the files that the user knows, before anything is
  // run or written.
  void read_problems(const fs::path& scene_file) {
    reading_scene(scene_file, [&] {
      for (const Node& value : read_problem_list(scene_))
        add_problem(read_problem(value, scene_folder(scene_file)), value);
    });
    for (scene::Value& problem : scene_["problems"].items())
      name_file_from_anywhere(problem["mesh"], scene_file);
  }

  void add_problem(const Problem& problem, const Node& value) {
    ProblemResult& result = comparison_.problems.emplace_back();
    result.name = problem.name;
    result.facts = problem.facts;
    for (const baselines::MethodInfo& info : baselines::methods())
      if (is_chosen(info))
        result.entries.push_back({info, why_not_applicable(info.name, problem.distortion), {}});
    for (const Entry& entry : result.entries)
      if (!entry.why_not_applicable.empty())
        notice(problem.name + ": " + std::string(entry.info.name) +
               " is not run: " + entry.why_not_applicable);
    // Where a file lies does not matter; what is in it does.
    scene::Value without_mesh = value.value();
    without_mesh.take("mesh");
    identities_.push_back(problem.facts.at("fingerprint").get<std::string>() + '\n' +
                          scene::to_json(without_mesh));
  }

  bool is_chosen(const baselines::MethodInfo& info) const {
    const auto& names = comparison_.options.methods;
    return std::find(names.begin(), names.end(), info.name) != names.end();
  }

  // The scene is written to another folder.
  static void name_file_from_anywhere(scene::Value& mesh, const fs::path& scene_file) {
    if (mesh.is_text()) mesh = fs::absolute(scene_folder(scene_file) / mesh.text()).string();
  }

  // Repetitions are outermost: what else the machine does for a while strikes all methods alike.
  void run_repetition(int number) {
    for (std::size_t p = 0; p < comparison_.problems.size(); ++p)
      for (Entry& entry : comparison_.problems[p].entries) {
        if (interrupted()) return;
        if (entry.why_not_applicable.empty()) run_once(p, entry, number);
      }
  }

  void run_once(std::size_t p, Entry& entry, int number) {
    const std::string& problem = comparison_.problems[p].name;
    const std::string method(entry.info.name);
    const std::string what =
        problem + ": " + method + formatted(", repetition %d of %d", number, comparison_.options.repetitions);
    show_progress(formatted("run %d of %d  ", ++begun_, wanted()) + what);
    const Run run = runs_.repetition(problem, method, number, identities_[p]);
    if (interrupted()) return;  // the next time it is made again, or found whole
    entry.runs.push_back(run);
    notice(what + ": " + run.status + formatted(", %.3g s, energy %.10g", run.seconds, run.energy()) +
           (run.has_summary() ? "" : ": " + run.message));
  }

  int wanted() const {
    int count = 0;
    for (const ProblemResult& problem : comparison_.problems)
      for (const Entry& entry : problem.entries) count += entry.why_not_applicable.empty() ? 1 : 0;
    return count * comparison_.options.repetitions;
  }

  int made() const {
    std::size_t count = 0;
    for (const ProblemResult& problem : comparison_.problems)
      for (const Entry& entry : problem.entries) count += entry.runs.size();
    return static_cast<int>(count);
  }

  // The least of all that was seen on the way, and of what the default makes of the best end.
  void find_optimum(std::size_t p) {
    ProblemResult& problem = comparison_.problems[p];
    for (const Entry& entry : problem.entries)
      for (const Run& run : entry.runs) take_least(problem, run, std::string(entry.info.name));
    const auto [best_entry, best_run] = best_end(problem);
    if (best_run == nullptr || interrupted()) return;
    show_progress(problem.name + ": the optimum");
    problem.polished = polish(p, *best_entry, *best_run);
    for (const Entry& entry : problem.entries)
      if (!interrupted() && &entry != best_entry) look_elsewhere(p, entry);
    std::erase_if(problem.elsewhere, [&](const OtherMinimum& minimum) {
      return !(problem.relative_error(minimum.energy) > same_minimum);
    });
  }

  static std::pair<const Entry*, const Run*> best_end(const ProblemResult& problem) {
    std::pair<const Entry*, const Run*> best{nullptr, nullptr};
    for (const Entry& entry : problem.entries)
      for (const Run& run : entry.runs)
        if (std::isfinite(run.energy()) && (best.second == nullptr || run.energy() < best.second->energy()))
          best = {&entry, &run};
    return best;
  }

  // A method that says it converged, far above the best, may only have stopped early: polishing tells.
  void look_elsewhere(std::size_t p, const Entry& entry) {
    const auto run =
        std::find_if(entry.runs.begin(), entry.runs.end(), [](const Run& r) { return r.converged; });
    if (run != entry.runs.end() && comparison_.problems[p].relative_error(run->energy()) > same_minimum)
      polish(p, entry, *run);
  }

  // Whether that went on until nothing improved any more.
  bool polish(std::size_t p, const Entry& entry, const Run& run) {
    ProblemResult& problem = comparison_.problems[p];
    const std::string method(entry.info.name);
    const Run end = runs_.polished(problem.name, method, run, identities_[p]);
    take_least(problem, end, default_method() + " from the end of " + method);
    const bool at_the_end = end.has_summary() && end.converged;
    if (at_the_end) problem.elsewhere.push_back({method, end.energy()});
    return at_the_end;
  }

  static void take_least(ProblemResult& problem, const Run& run, const std::string& whose) {
    std::vector<double> energies{run.energy()};
    for (const TraceRow& row : run.trace) energies.push_back(row.energy);
    for (const double energy : energies) {
      if (!std::isfinite(energy) || energy >= problem.optimum) continue;
      problem.optimum = energy;
      problem.optimum_of = whose;
      problem.optimum_folder = run.folder;
    }
  }

  void write(OutputFolder& folder) const {
    folder.add_json("comparison.json", comparison_json(comparison_));
    folder.add("runs.csv", run_table(comparison_));
    folder.add("methods.csv", method_table(comparison_));
    std::vector<NamedPicture> pictures;
    if (comparison_.options.picture) pictures = draw_all(comparison_);
    for (const NamedPicture& picture : pictures) {
      folder.add(picture.name + ".png", picture.png);
      folder.add(picture.name + ".svg", picture.svg);
    }
    folder.add("report.html", report_page(comparison_, pictures));
    folder.commit();
  }

  ExitCode conclude(const OutputFolder& folder) const {
    const Limits& limits = comparison_.options.limits;
    for (const ProblemResult& problem : comparison_.problems) {
      for (const std::string& line : verdicts(problem, limits)) print(problem.name + ": " + line + "\n");
      for (const std::string& line : reservations(problem, limits)) warn(problem.name + ": " + line);
    }
    const bool whole = !interrupted();
    return app::conclude(formatted("%d of %d runs compared", made(), wanted()) +
                             (whole ? "" : ", interrupted (Ctrl-C); the same command goes on"),
                         whole ? ExitCode::success : ExitCode::not_converged, folder, comparison_.options.out,
                         common_.verbose);
  }

  const CommonOptions& common_;
  scene::Value scene_;
  Comparison comparison_;
  std::vector<std::string> identities_;  // of the problems
  Runs runs_;
  int begun_ = 0;
};

}  // namespace

ExitCode compare(const CommandLine& command_line, const CommonOptions& common) {
  return Benchmark(command_line, common).run();
}

}  // namespace isostretch::app::compare

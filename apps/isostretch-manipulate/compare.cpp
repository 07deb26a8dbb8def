#include "compare.hpp"

#include <isostretch/core/numbers.hpp>
#include "common/interrupt.hpp"
#include "common/sequence_report.hpp"
#include "common/terminal.hpp"
#include "comparison.hpp"
#include "input.hpp"
#include "solver_run.hpp"

#include <isostretch/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isostretch::app::manipulate {
namespace {

namespace fs = std::filesystem;

// Of the run that says what the optimum is, which no limit of time ends.
constexpr double reference_gap = 1e-9, loose_gap = 1e-8;
constexpr int reference_iterations = 100;

class Benchmark {
 public:
  Benchmark(const CommandLine& command_line, const CommonOptions& common)
      : command_line_(command_line),
        common_(common),
        options_(command_line.options()),
        scene_(command_line.scene()),
        out_(options_.out) {
    choose();
    read();
    // Solvers decide on these.
    scene_.take("rival");
    if (scene::Value* group = scene_.find("manipulation"); group != nullptr)
      for (const char* key : {"method", "penalty", "relinearize"}) group->take(key);
    name_files_from_anywhere();
    runs_.scene_file = out_ / "scene.json";
    runs_.weights_cache = options_.weights_cache.empty() ? out_ / "weights" : options_.weights_cache;
    runs_.identity = fingerprint_ + '\n' + scene::to_json(scene_);
    runs_.refine = command_line.refine();
    runs_.threads = common.threads;
  }

  ExitCode run() {
    OutputFolder folder(out_);
    folder.write_now("scene.json", scene::to_json(scene_, 2) + "\n");
    Comparison comparison;
    comparison.name = name_;
    comparison.mesh = mesh_;
    comparison.repetitions = options_.repetitions;
    comparison.time_limit = options_.time_limit;
    comparison.memory_limit = options_.memory_limit;
    find_optimum(comparison);
    for (std::size_t i = 0; i < chosen_.size() && !interrupted(); ++i) {
      show_progress(formatted("solver %zu of %zu  ", i + 1, chosen_.size()) + std::string(chosen_[i].name));
      comparison.candidates.push_back(contest(chosen_[i]));
      report(comparison, comparison.candidates.back());
    }
    clear_progress();
    write(comparison, folder);
    return conclude(comparison, folder);
  }

 private:
  // As a run will: what is wrong is to be said once, of the files that the user knows.
  void read() {
    const SolidModel body = read_body(command_line_, scene_);
    const Scene scene = read_scene(command_line_, scene_, body);
    read_rig(command_line_, scene, body);
    name_ = command_line_.has_scene_file() ? command_line_.input().stem().string() : body.name;
    runs_.frame = read_range(options_, scene).last;
    gap_ = scene.solver.gap_tolerance;
    fingerprint_ = body.fingerprint();
    mesh_ = {{"name", body.name},
             {"nodes", body.nodes.rows()},
             {"elements", body.elements.element_count()},
             {"fingerprint", fingerprint_}};
  }

  // The scene is written to another folder.
  void name_files_from_anywhere() {
    const auto absolute = [&](scene::Value& file) {
      if (file.is_text()) file = fs::absolute(command_line_.folder() / file.text()).string();
    };
    if (scene_.has("mesh")) absolute(scene_["mesh"]);
    if (!scene_.has("photo")) return;
    scene::Value& photo = scene_["photo"];
    absolute(photo.has("file") ? photo["file"] : photo);
  }

  // "all", "convex", "alternative" or names with commas.
  void choose() {
    const std::vector<baselines::SolverInfo> all = baselines::solvers();
    for (const std::string& word : split(options_.compare, ',')) {
      const std::size_t before = chosen_.size();
      for (const baselines::SolverInfo& info : all)
        if (word == "all" || word == info.name ||
            word == (info.kind == baselines::Kind::convex ? "convex" : "alternative"))
          if (std::none_of(chosen_.begin(), chosen_.end(),
                           [&](const auto& c) { return c.name == info.name; }))
            chosen_.push_back(info);
      if (chosen_.size() > before) continue;
      if (std::any_of(chosen_.begin(), chosen_.end(), [&](const auto& c) { return c.name == word; }))
        continue;
      std::string names;
      for (const baselines::SolverInfo& info : all) names.append(", ").append(info.name);
      throw Error(ErrorKind::misuse,
                  "--compare: there is no solver '" + word + "'; there are all, convex, alternative" + names);
    }
  }

  Candidate contest(const baselines::SolverInfo& info) const {
    std::vector<Candidate> tries;
    do {
      const fs::path folder = run_folder(info, static_cast<int>(tries.size()));
      tries.push_back(runs_.candidate(
          info, {std::string(info.name), gap_, options_.time_limit, options_.memory_limit, 0, folder}));
    } while (static_cast<int>(tries.size()) < options_.repetitions && !interrupted());
    keep_most_frequent_outcome(tries);
    std::sort(tries.begin(), tries.end(),
              [](const Candidate& x, const Candidate& y) { return x.seconds < y.seconds; });
    const double least = tries.front().seconds, most = tries.back().seconds;
    Candidate median = std::move(tries[(tries.size() - 1) / 2]);
    median.least_seconds = least;
    median.most_seconds = most;
    return median;
  }

  // Times of a run that crashed say nothing about those that did not.
  static void keep_most_frequent_outcome(std::vector<Candidate>& tries) {
    const auto count = [&](const std::string& status) {
      return std::count_if(tries.begin(), tries.end(),
                           [&](const Candidate& c) { return c.status == status; });
    };
    std::string best = tries.front().status;
    for (const Candidate& c : tries)
      if (count(c.status) > count(best)) best = c.status;
    std::erase_if(tries, [&](const Candidate& c) { return c.status != best; });
  }

  fs::path run_folder(const baselines::SolverInfo& info, int repetition) const {
    const std::string name(info.name);
    return out_ / "runs" / (repetition == 0 ? name : name + formatted("_%d", repetition + 1));
  }

  // No limit ends this run. Where it does not reach a certified optimum, errors are left unknown.
  void find_optimum(Comparison& comparison) const {
    show_progress("the optimum");
    const Run run{"interior_point", reference_gap, 0, 0, reference_iterations, out_ / "runs" / "optimum"};
    const auto all = baselines::solvers();
    const auto info =
        std::find_if(all.begin(), all.end(), [&](const auto& i) { return i.name == run.solver; });
    const Candidate best = runs_.candidate(*info, run);
    if (interrupted())
      throw Error(ErrorKind::stopped,
                  "interrupted (Ctrl-C) before the optimum was known; the same command goes on");
    if (!best.has_positions() || best.frame.at("not_psd") != 0 || !best.frame.at("lower_bound").is_number())
      return warn("the optimum is not known (" + best.status + ": " + best.message + "), nor are errors");
    Comparison found = comparison;
    found.lower_bound = best.frame.at("lower_bound");
    found.optimum = best.frame.at("energy");
    const double gap = relative_error(found, found.lower_bound);
    if (!(gap <= std::max(gap_, loose_gap)))
      return warn(formatted("the optimum is not known, but to a share of %.1e (", gap) + best.message +
                  "), nor are errors");
    comparison = std::move(found);
    if (gap > loose_gap)
      warn(formatted("the optimum is known to a share of %.1e only (", gap) + best.message + ")");
  }

  static void report(const Comparison& comparison, const Candidate& c) {
    std::string text = std::string(c.info.name) + ": " + c.status + formatted(", %.3g s", c.seconds);
    if (c.has_positions()) {
      if (c.is_convex() && std::isfinite(comparison.optimum))
        text += formatted(", error %.1e", relative_error(comparison, c.frame.at("energy").get<double>()));
      text += formatted(", least eigenvalue %.1e, inverted %d", c.frame.at("min_eigenvalue").get<double>(),
                        c.frame.at("inverted").get<int>());
    } else if (!c.message.empty()) {
      text += ": " + c.message;
    }
    notice(text);
  }

  void write(const Comparison& comparison, OutputFolder& folder) const {
    folder.add("comparison.csv", comparison_table(comparison));
    folder.add_json("comparison.json", comparison_json(comparison));
    if (options_.picture) {
      const std::string plots = draw_comparison(comparison);
      folder.add("comparison.png", plots);
      folder.add("comparison.html", comparison_page(comparison, plots));
    }
    folder.commit();
  }

  ExitCode conclude(const Comparison& comparison, const OutputFolder& folder) const {
    const std::size_t done = comparison.candidates.size();
    const bool whole = done == chosen_.size();
    return app::conclude(formatted("%zu of %zu solvers compared", done, chosen_.size()) +
                             (whole ? "" : ", interrupted (Ctrl-C); the same command goes on"),
                         whole ? ExitCode::success : ExitCode::not_converged, folder, options_.out,
                         common_.verbose);
  }

  const CommandLine& command_line_;
  const CommonOptions& common_;
  Options options_;
  scene::Value scene_;
  fs::path out_;
  std::string name_;         // of the scene
  std::string fingerprint_;  // of the mesh, whose file may change
  Json mesh_;
  double gap_ = 0;
  SolverRuns runs_;
  std::vector<baselines::SolverInfo> chosen_;
};

}  // namespace

ExitCode compare(const CommandLine& command_line, const CommonOptions& common) {
  return Benchmark(command_line, common).run();
}

}  // namespace isostretch::app::manipulate

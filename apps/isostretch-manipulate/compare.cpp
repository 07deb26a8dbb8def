#include "compare.hpp"

#include "common/formatted.hpp"
#include "common/interrupt.hpp"
#include "common/numbers.hpp"
#include "common/sequence_report.hpp"
#include "common/terminal.hpp"
#include "comparison.hpp"
#include "input.hpp"

#include <isostretch/baselines/process.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

namespace isostretch::app::manipulate {
namespace {

namespace fs = std::filesystem;

// Of the run that says what the optimum is, which no limit of time ends.
constexpr double reference_gap = 1e-9, loose_gap = 1e-8;
// Beyond its own time limit a process is given the time to read, to measure and to write.
constexpr double grace_factor = 1.5, grace_seconds = 30;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// Null where there is none, or it is cut off.
Json json_of(const fs::path& file) {
  if (!fs::exists(file)) return nullptr;
  Json json = Json::parse(text_of(file), nullptr, false);
  return json.is_discarded() ? Json() : json;
}

double number_at(const std::vector<std::string>& cells, std::size_t column) {
  return column < cells.size()
             ? finite_number(cells[column]).value_or(std::numeric_limits<double>::quiet_NaN())
             : std::numeric_limits<double>::quiet_NaN();
}

std::vector<TraceRow> trace_of(const fs::path& file) {
  std::vector<TraceRow> rows;
  std::istringstream lines(text_of(file));
  std::string line;
  if (!std::getline(lines, line)) return rows;
  const std::vector<std::string> head = split(line, ',');
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::find(head.begin(), head.end(), name) - head.begin());
  };
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = split(line, ',');
    rows.push_back({static_cast<int>(number_at(cells, column("iteration"))),
                    number_at(cells, column("seconds")), number_at(cells, column("energy")),
                    number_at(cells, column("min_eigenvalue")), number_at(cells, column("min_det_F")),
                    static_cast<int>(number_at(cells, column("inverted")))});
  }
  return rows;
}

// A run in a folder of its own.
struct Run {
  std::string solver;
  double gap = 0;
  double time_limit = 0;  // 0: none
  fs::path folder;
};

class Match {
 public:
  Match(const CommandLine& command_line, const CommonOptions& common)
      : command_line_(command_line),
        common_(common),
        options_(command_line.options()),
        scene_(command_line.scene()),
        out_(options_.out) {
    choose();
    read();
    for (const char* key : {"method", "penalty", "solver"}) scene_.erase(key);
    name_files_from_anywhere();
  }

  ExitCode run() {
    OutputFolder folder(out_);
    folder.write_now("scene.json", scene_.dump(2) + "\n");
    Comparison comparison;
    comparison.name = name_;
    comparison.repetitions = options_.repetitions;
    comparison.time_limit = options_.time_limit;
    comparison.memory_limit = options_.memory_limit;
    find_optimum(comparison);
    for (std::size_t i = 0; i < chosen_.size() && !interrupted(); ++i) {
      show_progress(formatted("solver %zu of %zu  ", i + 1, chosen_.size()) + std::string(chosen_[i].name));
      comparison.contestants.push_back(contest(chosen_[i]));
      report(comparison, comparison.contestants.back());
    }
    clear_progress();
    write(comparison, folder);
    return conclude(comparison, folder);
  }

 private:
  // As a run will: what is wrong is to be said once, of the files that the user knows.
  void read() {
    const Body body = read_body(command_line_, scene_);
    const Scene scene = read_scene(command_line_, scene_, body);
    read_rig(command_line_, scene, body);
    name_ = command_line_.has_scene_file() ? command_line_.input().stem().string() : body.name;
    frame_ = read_range(options_, scene).last;
    gap_ = scene.solver.gap_tolerance;
  }

  // The scene is written to another folder.
  void name_files_from_anywhere() {
    const auto absolute = [&](Json& file) {
      if (file.is_string()) file = fs::absolute(command_line_.folder() / file.get<std::string>()).string();
    };
    if (scene_.contains("mesh")) absolute(scene_["mesh"]);
    if (!scene_.contains("photo")) return;
    Json& photo = scene_["photo"];
    absolute(photo.is_object() && photo.contains("file") ? photo["file"] : photo);
  }

  // "all", "convex", "nearby" or names with commas.
  void choose() {
    const std::vector<baselines::SolverInfo> all = baselines::solvers();
    for (const std::string& word : split(options_.compare, ',')) {
      const std::size_t before = chosen_.size();
      for (const baselines::SolverInfo& info : all)
        if (word == "all" || word == info.name ||
            word == (info.kind == baselines::Kind::convex ? "convex" : "nearby"))
          if (std::none_of(chosen_.begin(), chosen_.end(),
                           [&](const auto& c) { return c.name == info.name; }))
            chosen_.push_back(info);
      if (chosen_.size() > before) continue;
      if (std::any_of(chosen_.begin(), chosen_.end(), [&](const auto& c) { return c.name == word; }))
        continue;
      std::string names;
      for (const baselines::SolverInfo& info : all) names.append(", ").append(info.name);
      throw Failure(ExitCode::command_line,
                    "--compare: there is no solver '" + word + "'; there are all, convex, nearby" + names);
    }
  }

  // This very program with one solver.
  baselines::Command command(const Run& run) const {
    baselines::Command command;
    command.program = fs::read_symlink("/proc/self/exe").string();
    command.arguments = {(out_ / "scene.json").string(),
                         "--solver",
                         run.solver,
                         "--gap",
                         exact_text(run.gap),
                         "--out",
                         run.folder.string(),
                         "--weights-cache",
                         (out_ / "weights").string(),
                         "--no-picture",
                         "--refine",
                         std::to_string(command_line_.refine()),
                         "--frames",
                         formatted("%d:%d", frame_, frame_),
                         "--time-limit",
                         exact_text(run.time_limit),
                         "--memory-limit",
                         exact_text(options_.memory_limit)};
    if (common_.threads > 0)
      command.arguments.insert(command.arguments.end(), {"--threads", std::to_string(common_.threads)});
    command.output_file = fs::absolute(run.folder / "log.txt");
    command.errors_file = fs::absolute(run.folder / "errors.txt");
    return command;
  }

  // What a run depends on, kept beside its results: with the same it need not be made again.
  std::string account(const Run& run) const {
    std::string text = scene_.dump();
    for (const std::string& word : command(run).arguments) text.append(1, '\n').append(word);
    return text;
  }

  baselines::ProcessResult execute(const Run& run) const {
    fs::remove_all(run.folder);
    fs::create_directories(run.folder);
    baselines::ProcessLimits limits;
    if (run.time_limit > 0) limits.seconds = grace_factor * run.time_limit + grace_seconds;
    limits.megabytes = options_.memory_limit;
    const baselines::ProcessResult result =
        baselines::run_process(command(run), limits, [] { return !interrupted(); });
    if (!result.stopped) std::ofstream(run.folder / "run.txt") << account(run);
    return result;
  }

  Contestant contest(const baselines::SolverInfo& info) const {
    std::vector<Contestant> tries;
    do {
      const fs::path folder = run_folder(info, static_cast<int>(tries.size()));
      tries.push_back(attempt(info, {std::string(info.name), gap_, options_.time_limit, folder}));
    } while (static_cast<int>(tries.size()) < options_.repetitions && !interrupted());
    std::sort(tries.begin(), tries.end(),
              [](const Contestant& a, const Contestant& b) { return a.seconds < b.seconds; });
    const double least = tries.front().seconds, most = tries.back().seconds;
    Contestant median = std::move(tries[(tries.size() - 1) / 2]);
    median.least_seconds = least;
    median.most_seconds = most;
    return median;
  }

  fs::path run_folder(const baselines::SolverInfo& info, int repetition) const {
    const std::string name(info.name);
    return out_ / "runs" / (repetition == 0 ? name : name + formatted("_%d", repetition + 1));
  }

  Contestant attempt(const baselines::SolverInfo& info, const Run& run) const {
    Contestant contestant;
    contestant.info = info;
    if (!info.available()) {
      contestant.status = baselines::status_name(baselines::Status::unavailable);
      contestant.message = info.needs;
      return contestant;
    }
    baselines::ProcessResult process;
    if (fs::exists(run.folder / "run.txt") && text_of(run.folder / "run.txt") == account(run))
      read_process(run, process);
    else
      keep_process(run, process = execute(run));
    read_results(run, process, contestant);
    return contestant;
  }

  static void keep_process(const Run& run, const baselines::ProcessResult& p) {
    std::ofstream(run.folder / "process.json") << Json{{"exit_code", p.exit_code},
                                                       {"signal", p.signal},
                                                       {"timed_out", p.timed_out},
                                                       {"peak_megabytes", p.peak_megabytes},
                                                       {"seconds", p.seconds}}
                                                      .dump(2)
                                               << '\n';
  }

  static void read_process(const Run& run, baselines::ProcessResult& p) {
    const Json json = json_of(run.folder / "process.json");
    if (!json.is_object()) return;
    p.exit_code = json.value("exit_code", -1);
    p.signal = json.value("signal", 0);
    p.timed_out = json.value("timed_out", false);
    p.peak_megabytes = json.value("peak_megabytes", 0.0);
    p.seconds = json.value("seconds", 0.0);
  }

  static void read_results(const Run& run, const baselines::ProcessResult& process, Contestant& c) {
    c.peak_megabytes = process.peak_megabytes;
    c.seconds = process.seconds;
    const Json summary = json_of(run.folder / "summary.json");
    if (!summary.is_object()) return explain(run, process, c);
    c.frame = summary.at("frames").back();
    c.status = c.frame.at("status");
    c.message = c.frame.at("message");
    if (c.frame.contains("solver_seconds")) c.seconds = c.frame["solver_seconds"]["total"];
    c.trace = trace_of(run.folder / "trace.csv");
  }

  // The process has left no summary.
  static void explain(const Run& run, const baselines::ProcessResult& process, Contestant& c) {
    using baselines::Status;
    Status status = Status::failed;
    if (process.timed_out)
      status = Status::time_limit;
    else if (process.stopped)
      status = Status::callback;
    else if (process.signal != 0)
      status = Status::crashed;
    c.status = baselines::status_name(status);
    std::istringstream log(text_of(run.folder / "errors.txt"));
    for (std::string line; std::getline(log, line);)
      if (!line.empty()) c.message = line;
    if (process.signal != 0) c.message = formatted("ended by signal %d; ", process.signal) + c.message;
  }

  void find_optimum(Comparison& comparison) const {
    show_progress("the optimum");
    const Run run{"interior_point", reference_gap, 0, out_ / "runs" / "optimum"};
    const auto all = baselines::solvers();
    const auto info =
        std::find_if(all.begin(), all.end(), [&](const auto& i) { return i.name == run.solver; });
    const Contestant best = attempt(*info, run);
    const Json summary = json_of(run.folder / "summary.json");
    if (!summary.is_object()) throw Failure(ExitCode::solver_failed, "the reference run: " + best.message);
    comparison.mesh = summary.at("mesh");
    if (!best.has_positions())
      throw Failure(ExitCode::solver_failed, "the reference run: " + best.status + ", " + best.message);
    comparison.optimum = best.frame.at("energy");
    comparison.lower_bound = best.frame.at("lower_bound").is_number()
                                 ? best.frame.at("lower_bound").get<double>()
                                 : -std::numeric_limits<double>::infinity();
    const double gap = (comparison.optimum - comparison.lower_bound) / comparison.optimum;
    if (!(gap <= loose_gap))
      warn(formatted("the optimum is known to a share of %.1e only (", gap) + best.message + ")");
  }

  static void report(const Comparison& comparison, const Contestant& c) {
    std::string text = std::string(c.info.name) + ": " + c.status + formatted(", %.3g s", c.seconds);
    if (c.has_positions()) {
      if (c.is_convex())
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
    const std::size_t done = comparison.contestants.size();
    const bool whole = done == chosen_.size();
    return app::conclude(formatted("%zu of %zu solvers compared", done, chosen_.size()) +
                             (whole ? "" : ", interrupted (Ctrl-C); the same command goes on"),
                         whole ? ExitCode::success : ExitCode::not_converged, folder, options_.out,
                         common_.verbose);
  }

  const CommandLine& command_line_;
  const CommonOptions& common_;
  Options options_;
  Json scene_;
  fs::path out_;
  std::string name_;  // of the scene
  int frame_ = 1;
  double gap_ = 0;
  std::vector<baselines::SolverInfo> chosen_;
};

}  // namespace

ExitCode compare(const CommandLine& command_line, const CommonOptions& common) {
  return Match(command_line, common).run();
}

}  // namespace isostretch::app::manipulate

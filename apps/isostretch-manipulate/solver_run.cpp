#include "solver_run.hpp"

#include "common/exit_code.hpp"
#include "common/formatted.hpp"
#include "common/interrupt.hpp"
#include "common/numbers.hpp"

#include <isostretch/core/atomic_file.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string_view>
#include <utility>

namespace isostretch::app::manipulate {
namespace {

namespace fs = std::filesystem;

// Beyond its own time limit a process is given the time to read, to measure and to write.
constexpr double grace_factor = 3, grace_seconds = 60;

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
    if (!std::isfinite(number_at(cells, column("iteration"))) ||
        !std::isfinite(number_at(cells, column("inverted"))))
      continue;  // a line that was cut off
    rows.push_back({static_cast<int>(number_at(cells, column("iteration"))),
                    number_at(cells, column("seconds")), number_at(cells, column("energy")),
                    number_at(cells, column("min_eigenvalue")), number_at(cells, column("min_det_F")),
                    static_cast<int>(number_at(cells, column("inverted")))});
  }
  return rows;
}

// Where a run's programs exchange files: gone with it, however it ends.
fs::path temporary_of(const Run& run) {
  return run.folder / "temporary";
}

void write_file(const fs::path& path, std::string_view text) {
  AtomicFile file(path.string());
  file.write(text);
  file.commit();
}

void keep_process(const Run& run, const baselines::ProcessResult& p) {
  const Json json{{"exit_code", p.exit_code},
                  {"signal", p.signal},
                  {"timed_out", p.timed_out},
                  {"peak_megabytes", p.peak_megabytes},
                  {"seconds", p.seconds}};
  write_file(run.folder / "process.json", json.dump(2) + "\n");
}

baselines::ProcessResult read_process(const Run& run) {
  baselines::ProcessResult p;
  const Json json = json_of(run.folder / "process.json");
  if (!json.is_object()) return p;
  p.exit_code = json.value("exit_code", -1);
  p.signal = json.value("signal", 0);
  p.timed_out = json.value("timed_out", false);
  p.peak_megabytes = json.value("peak_megabytes", 0.0);
  p.seconds = json.value("seconds", 0.0);
  return p;
}

// A run that its time limit ended from outside has no summary; all others that are kept have.
bool is_whole(const Run& run) {
  return read_process(run).timed_out || json_of(run.folder / "summary.json").is_object();
}

bool speaks_of_memory(const std::string& text) {
  for (const char* word : {"memory", "bad_alloc", "failed to map"})
    if (text.find(word) != std::string::npos) return true;
  return false;
}

// The process has left no summary.
void explain(const Run& run, const baselines::ProcessResult& process, Contestant& c) {
  using baselines::Status;
  Status status = Status::failed;
  if (process.timed_out)
    status = Status::time_limit;
  else if (process.stopped)
    status = Status::callback;
  else if (speaks_of_memory(text_of(run.folder / "errors.txt")))
    status = Status::memory_limit;
  else if (process.signal != 0)
    status = Status::crashed;
  c.status = baselines::status_name(status);
  std::istringstream log(text_of(run.folder / "errors.txt"));
  for (std::string line; std::getline(log, line);)
    if (!line.empty()) c.message = line;
  if (process.signal != 0) c.message = formatted("ended by signal %d; ", process.signal) + c.message;
}

void read_results(const Run& run, const baselines::ProcessResult& process, Contestant& c) {
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

}  // namespace

std::string program_stamp() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  return std::to_string(fs::file_size(program)) + ' ' +
         std::to_string(fs::last_write_time(program).time_since_epoch().count());
}

baselines::Command SolverRuns::command(const Run& run) const {
  baselines::Command result;
  result.program = fs::read_symlink("/proc/self/exe").string();
  result.arguments = {scene_file.string(),
                      "--solver",
                      run.solver,
                      "--gap",
                      exact_text(run.gap),
                      "--out",
                      run.folder.string(),
                      "--weights-cache",
                      weights_cache.string(),
                      "--no-picture",
                      "--refine",
                      std::to_string(refine),
                      "--frames",
                      formatted("%d:%d", frame, frame),
                      "--time-limit",
                      exact_text(run.time_limit),
                      "--memory-limit",
                      exact_text(run.memory_limit)};
  if (run.max_iterations > 0)
    result.arguments.insert(result.arguments.end(), {"--max-iterations", std::to_string(run.max_iterations)});
  if (threads > 0) result.arguments.insert(result.arguments.end(), {"--threads", std::to_string(threads)});
  result.environment = {{"TMPDIR", fs::absolute(temporary_of(run)).string()}};
  result.output_file = fs::absolute(run.folder / "log.txt");
  result.errors_file = fs::absolute(run.folder / "errors.txt");
  return result;
}

// What a run depends on, kept beside its results: with the same it need not be made again.
std::string SolverRuns::account(const Run& run) const {
  std::string text = identity;
  for (const std::string& word : command(run).arguments) text.append(1, '\n').append(word);
  return text;
}

baselines::ProcessResult SolverRuns::execute(const Run& run) const {
  fs::remove_all(run.folder);
  fs::create_directories(temporary_of(run));
  baselines::ProcessLimits limits;
  if (run.time_limit > 0) limits.seconds = grace_factor * run.time_limit + grace_seconds;
  limits.megabytes = run.memory_limit;
  const baselines::ProcessResult result =
      baselines::run_process(command(run), limits, [] { return !interrupted(); });
  fs::remove_all(temporary_of(run));
  keep_process(run, result);
  if (!result.stopped && (result.timed_out || json_of(run.folder / "summary.json").is_object()))
    write_file(run.folder / "run.txt", account(run));  // the last: now it is whole
  return result;
}

Contestant SolverRuns::contestant(const baselines::SolverInfo& info, const Run& run) const {
  Contestant result;
  result.info = info;
  if (!info.available()) {
    result.status = baselines::status_name(baselines::Status::unavailable);
    result.message = info.needs;
    return result;
  }
  const bool is_there =
      fs::exists(run.folder / "run.txt") && text_of(run.folder / "run.txt") == account(run) && is_whole(run);
  const baselines::ProcessResult process =
      is_there ? read_process(run) : failing_with(ExitCode::output, [&] { return execute(run); });
  read_results(run, process, result);
  return result;
}

}  // namespace isostretch::app::manipulate

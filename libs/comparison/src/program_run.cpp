#include "json.hpp"

#include <isostretch/baselines/result.hpp>
#include <isostretch/comparison/program_run.hpp>
#include <isostretch/core/atomic_file.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>

#include <fstream>
#include <sstream>
#include <string_view>

namespace isostretch::comparison {
namespace {

namespace fs = std::filesystem;

// Beyond its own time limit a process is given the time to read, to measure and to write.
constexpr double grace_factor = 3, grace_seconds = 60;

fs::path this_program() {
  return fs::read_symlink("/proc/self/exe");
}

// What a run depends on, kept beside its results: with the same it need not be made again.
std::string account(const ProgramRun& run) {
  std::string text = file_stamp(this_program()) + '\n' + run.identity;
  for (const std::string& word : run.arguments) text.append(1, '\n').append(word);
  return text;
}

// Where the programs that a run starts exchange files: gone with it, however it ends.
fs::path temporary_of(const ProgramRun& run) {
  return run.folder / "temporary";
}

void write_file(const fs::path& path, std::string_view text) {
  AtomicFile file(path.string());
  file.write(text);
  file.commit();
}

void keep_process(const ProgramRun& run, const baselines::ProcessResult& p) {
  const Json json{{"exit_code", p.exit_code},
                  {"signal", p.signal},
                  {"timed_out", p.timed_out},
                  {"peak_megabytes", p.peak_megabytes},
                  {"seconds", p.seconds}};
  write_file(run.folder / "process.json", file_text(json));
}

baselines::ProcessResult read_process(const ProgramRun& run) {
  baselines::ProcessResult p;
  const Json json = json_of(Record::of_file(run.folder / "process.json"));
  if (!json.is_object()) return p;
  p.exit_code = json.value("exit_code", -1);
  p.signal = json.value("signal", 0);
  p.timed_out = json.value("timed_out", false);
  p.peak_megabytes = json.value("peak_megabytes", 0.0);
  p.seconds = json.value("seconds", 0.0);
  return p;
}

Record read_summary(const ProgramRun& run) {
  return Record::of_file(run.folder / "summary.json");
}

// A run that its time limit ended from outside may have no summary; all others that are kept have.
bool is_there(const ProgramRun& run) {
  return fs::exists(run.folder / "run.txt") && text_of(run.folder / "run.txt") == account(run) &&
         (read_process(run).timed_out || read_summary(run).is_object());
}

baselines::Command command(const ProgramRun& run) {
  baselines::Command result;
  result.program = this_program().string();
  result.arguments = run.arguments;
  result.environment = {{"TMPDIR", fs::absolute(temporary_of(run)).string()}};
  result.output_file = fs::absolute(run.folder / "log.txt");
  result.errors_file = fs::absolute(run.folder / "errors.txt");
  return result;
}

baselines::ProcessResult execute(const ProgramRun& run, const StopToken& stop) {
  fs::remove_all(run.folder);
  fs::create_directories(temporary_of(run));
  baselines::ProcessLimits limits;
  if (run.time_limit > 0) limits.seconds = grace_factor * run.time_limit + grace_seconds;
  limits.megabytes = run.memory_limit;
  const baselines::ProcessResult result =
      baselines::run_process(command(run), limits, [&] { return !stop.stop_requested(); });
  fs::remove_all(temporary_of(run));
  keep_process(run, result);
  if (!result.stopped && (result.timed_out || read_summary(run).is_object()))
    write_file(run.folder / "run.txt", account(run));  // the last: now it is whole
  return result;
}

bool speaks_of_memory(const std::string& text) {
  for (const char* word : {"memory", "bad_alloc", "failed to map"})
    if (text.find(word) != std::string::npos) return true;
  return false;
}

std::string last_line(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) last = line;
  return last;
}

void explain(const std::string& errors, ProgramResult& result) {
  using baselines::Status;
  const baselines::ProcessResult& process = result.process;
  const Status status = process.timed_out          ? Status::time_limit
                        : process.stopped          ? Status::callback
                        : speaks_of_memory(errors) ? Status::memory_limit
                        : process.signal != 0      ? Status::crashed
                                                   : Status::failed;
  result.status = baselines::status_name(status);
  result.message = last_line(errors);
  if (process.signal != 0)
    result.message = formatted("ended by signal %d; ", process.signal) + result.message;
}

}  // namespace

std::string file_stamp(const fs::path& file) {
  return std::to_string(fs::file_size(file)) + ' ' +
         std::to_string(fs::last_write_time(file).time_since_epoch().count());
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

ProgramResult run_program(const ProgramRun& run, const StopToken& stop) {
  ProgramResult result;
  result.process = is_there(run) ? read_process(run)
                                 : with_error_kind(ErrorKind::resource, [&] { return execute(run, stop); });
  // What a program writes when it is ended for its time says that somebody stopped it.
  if (!result.process.timed_out) result.summary = read_summary(run);
  if (!result.has_summary()) explain(text_of(run.folder / "errors.txt"), result);
  return result;
}

}  // namespace isostretch::comparison

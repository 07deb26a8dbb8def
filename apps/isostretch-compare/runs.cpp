#include "runs.hpp"

#include "common/machine.hpp"
#include "common/number_table.hpp"
#include "common/program_run.hpp"
#include "common/threads.hpp"

#include <isostretch/core/to_text.hpp>

#include <cmath>
#include <vector>

namespace isostretch::app::compare {
namespace {

namespace fs = std::filesystem;

constexpr int polishing_iterations = 1000;

std::vector<TraceRow> trace_of(const fs::path& file) {
  const NumberTable table(text_of(file));
  std::vector<TraceRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i)
    rows.push_back({table.at(i, "iteration"), table.at(i, "seconds"), table.at(i, "energy"),
                    table.at(i, "gradient_inf_norm")});
  return rows;
}

std::vector<std::string> arguments(const Runs& runs, const std::string& problem, const std::string& method,
                                   const Limits& limits, const fs::path& folder) {
  std::vector<std::string> words{"--scene",
                                 runs.scene_file.string(),
                                 "--run",
                                 problem,
                                 "--method",
                                 method,
                                 "--out",
                                 folder.string(),
                                 "--gradient-tolerance",
                                 to_text(limits.gradient_tolerance),
                                 "--max-iterations",
                                 std::to_string(limits.max_iterations),
                                 "--time-limit",
                                 to_text(limits.time_limit)};
  if (runs.threads > 0) words.insert(words.end(), {"--threads", std::to_string(runs.threads)});
  for (const std::string& plugin : runs.plugins)
    words.insert(words.end(), {"--plugin", fs::absolute(plugin).string()});
  return words;
}

void read_summary(const ProgramResult& result, Run& run) {
  run.status = result.status;
  run.message = result.message;
  run.seconds = result.process.seconds;
  run.peak_megabytes = result.process.peak_megabytes;
  if (!result.has_summary()) return;
  run.summary = result.summary;
  run.status = run.summary.at("status");
  run.message = run.summary.at("message");
  run.converged = run.summary.at("converged");
  run.seconds = run.summary.at("seconds").at("minimize");
}

Run made(const Runs& runs, ProgramRun program) {
  // The environment may choose the number of threads and more, and a folder may come from another machine.
  program.identity += "\nthreads " + std::to_string(thread_count()) + "\nmegabytes " +
                      to_text(program.memory_limit) + "\n" + machine_json().dump();
  for (const std::string& plugin : runs.plugins) program.identity += "\nplugin " + file_stamp(plugin);
  Run run;
  run.folder = fs::relative(program.folder, runs.out).string();
  read_summary(run_program(program), run);
  if (run.has_summary()) run.trace = trace_of(program.folder / "trace.csv");
  return run;
}

}  // namespace

Run Runs::repetition(const std::string& problem, const std::string& method, int number,
                     const std::string& identity) const {
  const fs::path folder = out / "runs" / problem / method / std::to_string(number);
  Run run = made(*this, {arguments(*this, problem, method, limits, folder), identity, folder,
                         limits.time_limit, limits.memory_limit});
  run.repetition = number;
  return run;
}

Run Runs::polished(const std::string& problem, const std::string& method, const Run& best,
                   const std::string& identity) const {
  const fs::path folder = out / "optimum" / problem / method;
  const Limits none{0, polishing_iterations, 0, limits.memory_limit};
  ProgramRun program{arguments(*this, problem, default_method(), none, folder), identity, folder, 0,
                     limits.memory_limit};
  program.arguments.insert(program.arguments.end(),
                           {"--from", (out / best.folder / "positions.bin").string()});
  // Another run in the same folder may end elsewhere.
  program.identity += "\nfrom energy " + to_text(best.energy());
  return made(*this, std::move(program));
}

}  // namespace isostretch::app::compare

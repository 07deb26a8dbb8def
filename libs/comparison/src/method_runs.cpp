#include "json.hpp"

#include <isostretch/comparison/method_runs.hpp>
#include <isostretch/comparison/number_table.hpp>
#include <isostretch/comparison/program_run.hpp>
#include <isostretch/core/to_text.hpp>

#include <cmath>
#include <vector>

namespace isostretch::comparison {
namespace {

namespace fs = std::filesystem;

constexpr int polishing_iterations = 1000;

std::vector<MethodTraceRow> trace_of(const fs::path& file) {
  const NumberTable table(text_of(file));
  std::vector<MethodTraceRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i)
    rows.push_back({table.at(i, "iteration"), table.at(i, "seconds"), table.at(i, "energy"),
                    table.at(i, "gradient_inf_norm")});
  return rows;
}

std::vector<std::string> arguments(const MethodRuns& runs, const std::string& problem,
                                   const std::string& method, const scene::ComparisonLimits& limits,
                                   const fs::path& folder) {
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

void read_summary(const ProgramResult& result, MethodRun& run) {
  run.status = result.status;
  run.message = result.message;
  run.seconds = result.process.seconds;
  run.peak_megabytes = result.process.peak_megabytes;
  if (!result.has_summary()) return;
  run.summary = result.summary;
  const Json& summary = json_of(run.summary);
  run.status = summary.at("status");
  run.message = summary.at("message");
  run.converged = summary.at("converged");
  run.seconds = summary.at("seconds").at("minimize");
}

MethodRun made(const MethodRuns& runs, ProgramRun program) {
  program.identity += "\nmegabytes " + to_text(program.memory_limit) + "\n" + runs.environment;
  for (const std::string& plugin : runs.plugins) program.identity += "\nplugin " + file_stamp(plugin);
  MethodRun run;
  run.folder = fs::relative(program.folder, runs.out).string();
  read_summary(run_program(program, runs.stop), run);
  if (run.has_summary()) run.trace = trace_of(program.folder / "trace.csv");
  return run;
}

}  // namespace

MethodRun MethodRuns::repetition(const ComparedProblem& problem, const std::string& method,
                                 int number) const {
  const fs::path folder = out / "runs" / problem.name / method / std::to_string(number);
  MethodRun run = made(*this, {arguments(*this, problem.name, method, limits, folder), problem.identity,
                               folder, limits.time_limit, limits.memory_limit});
  run.repetition = number;
  return run;
}

MethodRun MethodRuns::polished(const ComparedProblem& problem, const std::string& method,
                               const MethodRun& best) const {
  const fs::path folder = out / "optimum" / problem.name / method;
  const scene::ComparisonLimits none{0, polishing_iterations, 0, limits.memory_limit};
  ProgramRun program{arguments(*this, problem.name, default_method(), none, folder), problem.identity, folder,
                     0, limits.memory_limit};
  program.arguments.insert(program.arguments.end(),
                           {"--from", (out / best.folder / "positions.bin").string()});
  // Another run in the same folder may end elsewhere.
  program.identity += "\nfrom energy " + to_text(best.energy());
  return made(*this, std::move(program));
}

}  // namespace isostretch::comparison

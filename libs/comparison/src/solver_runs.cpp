#include "json.hpp"

#include <isostretch/comparison/number_table.hpp>
#include <isostretch/comparison/program_run.hpp>
#include <isostretch/comparison/solver_runs.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::comparison {
namespace {

namespace fs = std::filesystem;

constexpr double reference_gap = 1e-9;
constexpr int reference_iterations = 100;

// One run of a solver, in a folder of its own.
struct SolverRun {
  std::string solver;
  double gap = 0;
  double time_limit = 0;    // 0: none
  double memory_limit = 0;  // megabytes; 0: none
  int max_iterations = 0;   // 0: as the scene has it
  fs::path folder;
};

std::vector<SolverTraceRow> trace_of(const fs::path& file) {
  const NumberTable table(text_of(file));
  std::vector<SolverTraceRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!std::isfinite(table.at(i, "iteration")) || !std::isfinite(table.at(i, "inverted"))) continue;
    rows.push_back({static_cast<int>(table.at(i, "iteration")), table.at(i, "seconds"), table.at(i, "energy"),
                    table.at(i, "min_eigenvalue"), table.at(i, "min_det_F"),
                    static_cast<int>(table.at(i, "inverted"))});
  }
  return rows;
}

void read_results(const SolverRun& run, const ProgramResult& result, SolverCandidate& c) {
  c.peak_megabytes = result.process.peak_megabytes;
  c.seconds = result.process.seconds;
  c.status = result.status;
  c.message = result.message;
  if (!result.has_summary()) return;
  const Json& frame = json_of(result.summary).at("frames").back();
  c.status = frame.at("status");
  c.message = frame.at("message");
  if (frame.contains("solver_seconds")) c.seconds = frame["solver_seconds"]["total"];
  c.frame = record_of(frame);
  c.trace = trace_of(run.folder / "trace.csv");
}

std::vector<std::string> arguments(const SolverRuns& runs, const SolverRun& run) {
  std::vector<std::string> words{runs.scene_file.string(),
                                 "--rival",
                                 run.solver,
                                 "--gap-tolerance",
                                 to_text(run.gap),
                                 "--out",
                                 run.folder.string(),
                                 "--weights-cache",
                                 runs.weights_cache.string(),
                                 "--no-picture",
                                 "--refine",
                                 std::to_string(runs.refine),
                                 "--frames",
                                 formatted("%d:%d", runs.frame, runs.frame),
                                 "--time-limit",
                                 to_text(run.time_limit),
                                 "--memory-limit",
                                 to_text(run.memory_limit)};
  if (run.max_iterations > 0)
    words.insert(words.end(), {"--max-iterations", std::to_string(run.max_iterations)});
  if (runs.threads > 0) words.insert(words.end(), {"--threads", std::to_string(runs.threads)});
  return words;
}

SolverCandidate made(const SolverRuns& runs, const baselines::SolverInfo& info, const SolverRun& run) {
  SolverCandidate result;
  result.info = info;
  if (!info.available()) {
    result.status = baselines::status_name(baselines::Status::unavailable);
    result.message = info.needs;
    return result;
  }
  const ProgramRun program{arguments(runs, run), runs.identity, run.folder, run.time_limit, run.memory_limit};
  read_results(run, run_program(program, runs.stop), result);
  return result;
}

}  // namespace

SolverCandidate SolverRuns::repetition(const baselines::SolverInfo& info, int number) const {
  const std::string name(info.name);
  const fs::path folder = out / "runs" / (number == 0 ? name : name + formatted("_%d", number + 1));
  return made(*this, info, {name, gap, time_limit, memory_limit, 0, folder});
}

SolverCandidate SolverRuns::candidate(const baselines::SolverInfo& info, int repetitions) const {
  std::vector<SolverCandidate> all;
  do all.push_back(repetition(info, static_cast<int>(all.size())));
  while (static_cast<int>(all.size()) < repetitions && !stop.stop_requested());
  return median_candidate(std::move(all));
}

SolverCandidate SolverRuns::optimum() const {
  const SolverRun run{"interior_point", reference_gap, 0, 0, reference_iterations, out / "runs" / "optimum"};
  const auto all = baselines::solvers();
  const auto info = std::find_if(all.begin(), all.end(), [&](const auto& i) { return i.name == run.solver; });
  return made(*this, *info, run);
}

}  // namespace isostretch::comparison

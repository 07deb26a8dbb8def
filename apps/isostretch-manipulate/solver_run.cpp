#include "solver_run.hpp"

#include "common/number_table.hpp"
#include "common/program_run.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::app::manipulate {
namespace {

std::vector<TraceRow> trace_of(const std::filesystem::path& file) {
  const NumberTable table(text_of(file));
  std::vector<TraceRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!std::isfinite(table.at(i, "iteration")) || !std::isfinite(table.at(i, "inverted"))) continue;
    rows.push_back({static_cast<int>(table.at(i, "iteration")), table.at(i, "seconds"), table.at(i, "energy"),
                    table.at(i, "min_eigenvalue"), table.at(i, "min_det_F"),
                    static_cast<int>(table.at(i, "inverted"))});
  }
  return rows;
}

void read_results(const Run& run, const ProgramResult& result, Candidate& c) {
  c.peak_megabytes = result.process.peak_megabytes;
  c.seconds = result.process.seconds;
  c.status = result.status;
  c.message = result.message;
  if (!result.has_summary()) return;
  c.frame = result.summary.at("frames").back();
  c.status = c.frame.at("status");
  c.message = c.frame.at("message");
  if (c.frame.contains("solver_seconds")) c.seconds = c.frame["solver_seconds"]["total"];
  c.trace = trace_of(run.folder / "trace.csv");
}

}  // namespace

std::vector<std::string> SolverRuns::arguments(const Run& run) const {
  std::vector<std::string> words{scene_file.string(),
                                 "--rival",
                                 run.solver,
                                 "--gap-tolerance",
                                 to_text(run.gap),
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
                                 to_text(run.time_limit),
                                 "--memory-limit",
                                 to_text(run.memory_limit)};
  if (run.max_iterations > 0)
    words.insert(words.end(), {"--max-iterations", std::to_string(run.max_iterations)});
  if (threads > 0) words.insert(words.end(), {"--threads", std::to_string(threads)});
  return words;
}

Candidate SolverRuns::candidate(const baselines::SolverInfo& info, const Run& run) const {
  Candidate result;
  result.info = info;
  if (!info.available()) {
    result.status = baselines::status_name(baselines::Status::unavailable);
    result.message = info.needs;
    return result;
  }
  const ProgramRun program{arguments(run), identity, run.folder, run.time_limit, run.memory_limit};
  read_results(run, run_program(program), result);
  return result;
}

}  // namespace isostretch::app::manipulate

#include "compare.hpp"

#include "common/monitor.hpp"
#include "common/results.hpp"
#include "common/threads.hpp"
#include "input.hpp"

#include <isostretch/comparison/solver_benchmark.hpp>

namespace isostretch::app::manipulate {
namespace {

// As a run will: what is wrong is to be said once, of the files that the user knows.
comparison::SolverBenchmark benchmark(const CommandLine& command_line, const CommonOptions& common) {
  const Options options = command_line.options();
  const scene::Value value = command_line.scene();
  comparison::SolverBenchmarkOptions result{.solvers = options.compare,
                                            .out = options.out,
                                            .weights_cache = options.weights_cache,
                                            .repetitions = options.repetitions,
                                            .refine = command_line.refine(),
                                            .threads = common.threads,
                                            .thread_count = thread_count(),
                                            .time_limit = options.time_limit,
                                            .memory_limit = options.memory_limit,
                                            .picture = options.picture};
  with_error_kind(ErrorKind::misuse, [&] {
    with_error_prefix("--compare", [&] { comparison::choose_solvers(options.compare); });
  });
  const SolidModel body = read_body(command_line, value);
  const Scene scene = read_scene(command_line, value, body);
  read_rig(command_line, scene, body);
  result.frame = read_range(options, scene).last;
  result.gap = scene.solver.gap_tolerance;
  return {value, command_line.folder(),
          command_line.has_scene_file() ? command_line.input().stem().string() : body.name, body, result};
}

}  // namespace

ExitCode compare(const CommandLine& command_line, const CommonOptions& common) {
  comparison::SolverBenchmark solvers = benchmark(command_line, common);
  const std::filesystem::path out = command_line.options().out;
  OutputFolder folder(out);
  solvers.run(folder, terminal_monitor());
  folder.commit();
  return conclude(solvers.verdict(), solvers.whole() ? ExitCode::success : ExitCode::not_converged, folder,
                  out, common.verbose);
}

}  // namespace isostretch::app::manipulate

#include "single_run.hpp"

#include "common/interrupt.hpp"
#include "common/scene_input.hpp"
#include "common/terminal.hpp"
#include "common/threads.hpp"

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/comparison/machine.hpp>
#include <isostretch/comparison/method_scene.hpp>
#include <isostretch/comparison/method_summary.hpp>
#include <isostretch/comparison/problem.hpp>
#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/text.hpp>

#include <fstream>
#include <string_view>

namespace isostretch::app::compare {
namespace {

namespace fs = std::filesystem;
using comparison::Problem;
using comparison::problem_name;

Problem problem_named(const std::string& name, const scene::Value& scene, const fs::path& scene_file) {
  return reading_scene(scene_file, [&] {
    std::vector<std::string> names;
    for (const scene::Node& value : comparison::read_problem_list(scene)) {
      if (problem_name(value) == name) return comparison::read_problem(value, scene_folder(scene_file), warn);
      names.push_back(problem_name(value));
    }
    throw Error(ErrorKind::misuse, "--run: there is no problem '" + name + "'; there are " + listed(names));
  });
}

Vector read_positions(const fs::path& file, Eigen::Index size) {
  Vector x(size);
  const auto bytes = static_cast<std::streamsize>(static_cast<std::size_t>(size) * sizeof(double));
  std::ifstream in(file, std::ios::binary);
  if (!in || !fs::is_regular_file(file) || fs::file_size(file) != static_cast<std::uintmax_t>(bytes) ||
      !in.read(reinterpret_cast<char*>(x.data()), bytes))
    throw Error(ErrorKind::input,
                file.string() + ": must hold " + std::to_string(size) + " numbers of this problem");
  return x;
}

std::string_view bytes_of(const Vector& x) {
  return {reinterpret_cast<const char*>(x.data()), static_cast<std::size_t>(x.size()) * sizeof(double)};
}

newton::Summary minimize(const SingleRun& run, const Problem& problem, Vector& x) {
  const baselines::MethodOptions options{run.limits.gradient_tolerance, run.limits.max_iterations,
                                         run.limits.time_limit};
  newton::Summary summary = baselines::minimize(
      run.method, problem.distortion, x, options, [](const newton::Iteration& row, const Vector&) {
        show_progress(newton::progress_line(row));
        return interrupted() ? newton::CallbackAction::stop : newton::CallbackAction::proceed;
      });
  if (summary.status == newton::Status::stopped_by_callback) summary.message = "interrupted (Ctrl-C)";
  return summary;
}

ExitCode exit_code(const newton::Summary& summary) {
  if (newton::failed(summary.status)) return ExitCode::solver_failed;
  return summary.converged() ? ExitCode::success : ExitCode::not_converged;
}

}  // namespace

ExitCode run_single(const SingleRun& run, const scene::Value& scene, const fs::path& scene_file) {
  const Problem problem = problem_named(run.problem, scene, scene_file);
  Vector x = run.from.empty() ? problem.start : read_positions(run.from, problem.start.size());
  OutputFolder folder(run.out);
  const newton::Summary summary =
      with_error_kind(ErrorKind::unsolved, [&] { return minimize(run, problem, x); });
  folder.add("trace.csv", to_csv(newton::trace_table(summary)));
  folder.add("positions.bin", bytes_of(x));
  folder.add("summary.json", comparison::method_summary(problem, run.method, summary, x,
                                                        comparison::machine_record(thread_count())));
  folder.commit();
  print(summary.brief_report() + "\n");
  return exit_code(summary);
}

}  // namespace isostretch::app::compare

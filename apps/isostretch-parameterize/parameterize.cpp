#include "parameterize.hpp"

#include "common/monitor.hpp"
#include "common/terminal.hpp"
#include "common/threads.hpp"
#include "common/timed.hpp"
#include "input.hpp"
#include "uv_file.hpp"

#include <isostretch/core/output_folder.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/figures/parameterization_figures.hpp>
#include <isostretch/reports/parameterization_report.hpp>

#include <future>

namespace isostretch::app::parameterize {
namespace {

using reports::ParameterizationReport;

struct Written {
  std::string model_png = {}, layout_png = {};
  std::string trouble = {};  // what could not be written, and why
};

// glTF has floats: what does not fit into them is no reason to lose the rest.
std::string add_glb(OutputFolder& folder, const ParameterizationReport& report) {
  const std::string name = report.model.stem().string() + "_uv.glb";
  try {
    folder.add(name, figures::textured_glb(report.result));
    return {};
  } catch (const Error& error) {
    return name + " is not written: " + error.what();
  }
}

Written write(OutputFolder& folder, const ParameterizationReport& report, const Input& input,
              const Options& options) {
  const std::string stem = options.model.stem().string();
  folder.add(stem + "_uv.obj", uv_file(input, report.result));
  folder.add("trace.csv", reports::trace_text(report));
  Written written;
  if (options.glb) written.trouble = add_glb(folder, report);
  if (!options.picture) return written;
  const figures::ParameterizationFigure figure{
      report.result, options.model.filename().string() + ", " + options.energy.name(),
      options.units() == parameterization::UvUnits::square};
  auto layout = std::async(std::launch::async, [&] { return figures::draw_layout(figure); });
  written.model_png = figures::draw_model(figure);
  written.layout_png = layout.get();
  folder.add("layout.png", written.layout_png);
  folder.add("model.png", written.model_png);
  return written;
}

ExitCode conclude(const ParameterizationReport& report, const OutputFolder& folder,
                  const CommonOptions& common, const std::string& trouble) {
  if (common.verbose) print(report.result.solution.summary.full_report());
  for (const auto& path : folder.paths()) print("wrote " + path.string() + "\n");
  for (const std::string& warning : layout_warnings(report)) warn(warning);
  print(outcome(report) + "\n");
  const ExitCode code = exit_code_of(status(report));
  if (code != ExitCode::success) report_error(verdict(report));
  if (!trouble.empty()) report_error(trouble);
  return code == ExitCode::success && !trouble.empty() ? ExitCode::output : code;
}

ExitCode print_check(const Options& options) {
  const mesh::MeshDiagnostics report = mesh::check(read_input(options).mesh);
  print(to_text(report));
  return flattenable(report) ? ExitCode::success : ExitCode::input;
}

parameterization::Parameterization flatten(const Input& input, const Options& options) {
  return with_error_prefix(options.model.string(), [&] {
    try {
      return parameterization::parameterize(input.mesh, options.energy, options, terminal_monitor());
    } catch (const Error& error) {
      if (error.has_kind() || options.initial == Initial::input || options.repair ||
          !repair_would_help(input.mesh))
        throw;
      throw Error(std::string(error.what()) + "; --repair mends that");
    }
  });
}

}  // namespace

ExitCode parameterize(const Options& options, const CommonOptions& common) {
  if (options.check) return print_check(options);
  const Timer timer;
  reports::RunFacts facts{.threads = thread_count()};
  const Input input = timed(facts.read, [&] { return read_input(options); });
  OutputFolder folder(options.out);
  const parameterization::Parameterization result = flatten(input, options);
  clear_progress();
  facts.read += result.times.seconds("domain");
  facts.initial = result.times.seconds("start");
  const ParameterizationReport report{result,        options,        options.energy, options.model,
                                      input.repairs, options.repair, options.weld};
  const Written written = timed(facts.write, [&] { return write(folder, report, input, options); });
  facts.total = timer.seconds();
  folder.add("summary.json", reports::summary_text(report, facts));
  if (options.picture)
    folder.add("report.html", reports::report_page(report, facts, written.model_png, written.layout_png));
  folder.commit();
  return conclude(report, folder, common, written.trouble);
}

}  // namespace isostretch::app::parameterize

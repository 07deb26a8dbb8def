#include "parameterize.hpp"

#include "common/monitor.hpp"
#include "common/output_folder.hpp"
#include "common/terminal.hpp"
#include "common/timed.hpp"
#include "model_picture.hpp"
#include "outcome.hpp"
#include "report_page.hpp"
#include "textured_glb.hpp"
#include "uv_file.hpp"

#include <nlohmann/json.hpp>

#include <future>

#include <isostretch/core/timer.hpp>
#include <isostretch/mesh_io/io.hpp>

namespace isostretch::app::parameterize {
namespace {

struct Written {
  Pictures pictures;
  std::string trouble = {};  // what could not be written, and why
};

// glTF has floats: what does not fit into them is no reason to lose the rest.
std::string add_glb(OutputFolder& folder, const Result& result) {
  const std::string name = result.options.model.stem().string() + "_uv.glb";
  try {
    folder.add(name, textured_glb(result));
    return {};
  } catch (const Error& error) {
    return name + " is not written: " + error.what();
  }
}

Written write(OutputFolder& folder, const Result& result) {
  const Options& options = result.options;
  const std::string stem = options.model.stem().string();
  folder.add(stem + "_uv.obj", uv_file(result));
  folder.add("trace.csv", trace_text(result));
  Written written;
  if (options.glb) written.trouble = add_glb(folder, result);
  if (!options.picture) return written;
  auto layout = std::async(std::launch::async, [&] { return draw_layout(result); });
  written.pictures.model = draw_model(result);
  written.pictures.layout = layout.get();
  folder.add("layout.png", written.pictures.layout);
  folder.add("model.png", written.pictures.model);
  return written;
}

ExitCode conclude(const Result& result, const OutputFolder& folder, const CommonOptions& common,
                  const std::string& trouble) {
  if (common.verbose) print(result.solution.summary.full_report());
  for (const auto& path : folder.paths()) print("wrote " + path.string() + "\n");
  for (const std::string& warning : layout_warnings(result)) warn(warning);
  print(outcome(result) + "\n");
  const ExitCode code = exit_code(result);
  if (code != ExitCode::success) report_error(verdict(result));
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
  PhaseSeconds seconds;
  const Input input = timed(seconds.read, [&] { return read_input(options); });
  OutputFolder folder(options.out);
  const parameterization::Parameterization p = flatten(input, options);
  clear_progress();
  seconds.read += p.times.seconds("domain");
  seconds.initial = p.times.seconds("start");
  const Result result{options, options.energy, input, p, p.domain, p.start, p.solution, p.layout, p.split};
  const Written written = timed(seconds.write, [&] { return write(folder, result); });
  seconds.total = timer.seconds();
  const Json summary = summary_json(result, seconds);
  folder.add_json("summary.json", summary);
  if (options.picture) folder.add("report.html", report_page(result, summary, written.pictures));
  folder.commit();
  return conclude(result, folder, common, written.trouble);
}

}  // namespace isostretch::app::parameterize

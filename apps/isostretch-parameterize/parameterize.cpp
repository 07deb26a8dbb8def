#include "parameterize.hpp"

#include "common/newton_report.hpp"
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
#include <isostretch/mesh/io.hpp>

namespace isostretch::app::parameterize {
namespace {

Pictures write(OutputFolder& folder, const Result& result) {
  const Options& options = result.options;
  const std::string stem = options.model.stem().string();
  folder.add(stem + "_uv.obj", uv_file(result));
  folder.add("trace.csv", trace_text(result));
  if (options.glb) folder.add(stem + "_uv.glb", textured_glb(result));
  if (!options.picture) return {};
  auto layout = std::async(std::launch::async, [&] { return draw_layout(result); });
  Pictures pictures{draw_model(result), {}};
  pictures.layout = layout.get();
  folder.add("layout.png", pictures.layout);
  folder.add("model.png", pictures.model);
  return pictures;
}

ExitCode conclude(const Result& result, const OutputFolder& folder, const CommonOptions& common) {
  if (common.verbose) print(result.solution.summary.full_report());
  for (const auto& path : folder.paths()) print("wrote " + path.string() + "\n");
  for (const std::string& warning : layout_warnings(result)) warn(warning);
  print(outcome(result) + "\n");
  const ExitCode code = exit_code(result);
  if (code != ExitCode::success) report_error(verdict(result));
  return code;
}

ExitCode print_check(const Options& options) {
  bool clean = false;
  print(check_report(options, clean));
  return clean ? ExitCode::success : ExitCode::input;
}

}  // namespace

ExitCode parameterize(const Options& options, const energies::AnyEnergy& energy,
                      const CommonOptions& common) {
  if (options.check) return print_check(options);
  const Timer timer;
  PhaseSeconds seconds;
  Domain domain = timed(seconds.read, [&] { return read_domain(options); });
  Start start = timed(seconds.initial, [&] { return make_start(domain, energy, options); });
  OutputFolder folder(options.out);
  Solution solution = solve(domain, start, energy, options);
  const OverlapSplit split = split_overlap(domain, start, solution, options);
  const Layout layout = lay_out(domain, start, solution, options);
  const Result result{options, energy, domain, start, solution, layout, split};
  const Pictures pictures = timed(seconds.write, [&] { return write(folder, result); });
  seconds.total = timer.seconds();
  const Json summary = summary_json(result, seconds);
  folder.add_json("summary.json", summary);
  if (options.picture) folder.add("report.html", report_page(result, summary, pictures));
  folder.commit();
  return conclude(result, folder, common);
}

}  // namespace isostretch::app::parameterize

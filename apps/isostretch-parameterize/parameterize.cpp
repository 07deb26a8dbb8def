#include "parameterize.hpp"

#include "common/newton_report.hpp"
#include "common/output_folder.hpp"
#include "common/terminal.hpp"
#include "report.hpp"

#include <isostretch/core/timer.hpp>
#include <isostretch/mesh/io.hpp>

namespace isostretch::app::parameterize {
namespace {

template <class Work>
auto timed(double& seconds, Work&& work) {
  const ScopedTimer timer(seconds);
  return work();
}

void write(OutputFolder& folder, const Result& result) {
  const Options& options = result.options;
  const std::string stem = options.model.stem().string();
  folder.add(stem + "_uv.obj", mesh::format_obj(textured(result)));
  folder.add("trace.csv", trace_text(result));
  if (options.picture) folder.add("layout.png", draw_layout(result));
}

ExitCode conclude(const Result& result, const OutputFolder& folder, const CommonOptions& common) {
  const newton::Summary& summary = result.solution.summary;
  print(common.verbose ? summary.full_report() : summary.brief_report() + "\n");
  for (const auto& path : folder.paths()) print("wrote " + path.string() + "\n");
  const ExitCode code = exit_code(result);
  if (code != ExitCode::success) report_error(verdict(result));
  return code;
}

}  // namespace

ExitCode parameterize(const Options& options, const energies::AnyEnergy& energy,
                      const CommonOptions& common) {
  const Timer timer;
  PhaseSeconds seconds;
  Domain domain = timed(seconds.read, [&] { return read_domain(options); });
  Start start = timed(seconds.initial, [&] { return make_start(domain, energy, options); });
  OutputFolder folder(options.out);
  const Solution solution = solve(domain, start, energy, options);
  const Layout layout = lay_out(domain, start, solution, options);
  const Result result{options, energy, domain, start, solution, layout};
  timed(seconds.write, [&] { write(folder, result); });
  seconds.total = timer.seconds();
  folder.add_json("summary.json", summary_json(result, seconds));
  folder.commit();
  return conclude(result, folder, common);
}

}  // namespace isostretch::app::parameterize

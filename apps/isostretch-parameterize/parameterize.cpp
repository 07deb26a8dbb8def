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

void write(OutputFolder& folder, const Domain& domain, const Start& start, const energies::AnyEnergy& energy,
           const Solution& solution, const Options& options) {
  const std::string stem = options.model.stem().string();
  folder.add(stem + "_uv.obj", mesh::format_obj(textured(domain, solution)));
  folder.add("trace.csv", trace_csv(solution.summary));
  if (options.picture) folder.add("layout.png", draw(domain, start, energy, solution, options));
}

ExitCode conclude(const Solution& solution, const OutputFolder& folder, const CommonOptions& common) {
  print((common.verbose ? solution.summary.full_report() : solution.summary.brief_report() + "\n"));
  for (const auto& path : folder.paths()) print("wrote " + path.string() + "\n");
  const ExitCode code = exit_code(solution);
  if (code != ExitCode::success) report_error(verdict(solution));
  return code;
}

}  // namespace

ExitCode parameterize(const Options& options, const energies::AnyEnergy& energy,
                      const CommonOptions& common) {
  const Timer timer;
  PhaseSeconds seconds;
  const Domain domain = timed(seconds.read, [&] { return read_domain(options); });
  const Start start = timed(seconds.initial, [&] { return make_start(domain, energy, options); });
  OutputFolder folder(options.out);
  const Solution solution = solve(domain, start, energy, options);
  timed(seconds.write, [&] { write(folder, domain, start, energy, solution, options); });
  seconds.total = timer.seconds();
  folder.add_json("summary.json", summary_json(domain, start, energy, solution, options, seconds));
  folder.commit();
  return conclude(solution, folder, common);
}

}  // namespace isostretch::app::parameterize

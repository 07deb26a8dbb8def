#include "inspect.hpp"

#include "common/results.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/output_folder.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/figures/energy_maps.hpp>
#include <isostretch/reports/energy_report.hpp>
#include <isostretch/scene/energy_choice.hpp>

#include <algorithm>
#include <optional>

namespace isostretch::app::inspect {
namespace {

using inspection::Findings;
using inspection::Study;

energies::AnyEnergy read_energy(const Options& options) {
  const std::string& text = options.energy;
  if (options.dimensions != Dimensions::both)
    return scene::choose_energy(text, options.parameters, static_cast<int>(options.dimensions));
  if (expressions::is_expression(text)) return expressions::parse_energy(text, options.parameters);
  const auto in_plane = scene::energy_names_in(2);
  const bool is_in_plane = std::find(in_plane.begin(), in_plane.end(), text) != in_plane.end();
  return scene::choose_energy(text, options.parameters, is_in_plane ? 2 : 3);
}

Findings look_at(const energies::AnyEnergy& energy, const Options& options) {
  std::optional<int> dim;
  if (options.dimensions != Dimensions::both) dim = static_cast<int>(options.dimensions);
  return inspection::inspect(energy, options.energy, options.range, dim);
}

void write(const Findings& findings, OutputFolder& folder) {
  std::vector<std::string> maps;
  for (const Study& study : findings.studies) {
    const std::string name = formatted("maps_%dd", study.dim);
    const figures::EnergyMaps drawn(findings.energy, study.dim, findings.range);
    maps.push_back(drawn.draw(figures::PictureFormat::png));
    folder.add(name + ".png", maps.back());
    folder.add(name + ".svg", drawn.draw(figures::PictureFormat::svg));
  }
  folder.add("summary.json", reports::summary_text(findings));
  folder.add("report.html", reports::report_page(findings, maps));
  folder.commit();
}

}  // namespace

ExitCode inspect(const CommandLine& command_line, const CommonOptions& common) {
  const Options options = command_line.options();
  const energies::AnyEnergy energy = with_error_kind(ErrorKind::misuse, [&] { return read_energy(options); });
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  const Findings findings = look_at(energy, options);
  print(reports::report_text(findings));
  if (!folder) return ExitCode::success;
  write(findings, *folder);
  return conclude(inspection::verdict(findings), ExitCode::success, *folder, options.out, common.verbose);
}

}  // namespace isostretch::app::inspect

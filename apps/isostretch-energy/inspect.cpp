#include "inspect.hpp"

#include "common/sequence_report.hpp"
#include "common/terminal.hpp"
#include "maps.hpp"
#include "report.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/scene/energy_choice.hpp>

#include <algorithm>
#include <optional>

namespace isostretch::app::inspect {
namespace {

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
  Findings findings{options, energy, {}};
  for (const int dim : {2, 3})
    if (energy.supports(dim) &&
        (options.dimensions == Dimensions::both || static_cast<int>(options.dimensions) == dim))
      findings.studies.push_back(study(energy, dim, options));
  return findings;
}

void write(const Findings& findings, OutputFolder& folder) {
  std::vector<std::string> maps;
  for (const Study& study : findings.studies) {
    const std::string name = formatted("maps_%dd", study.dim);
    const Maps drawn(findings.energy, study.dim, findings.options.range);
    maps.push_back(drawn.draw(figures::PictureFormat::png));
    folder.add(name + ".png", maps.back());
    folder.add(name + ".svg", drawn.draw(figures::PictureFormat::svg));
  }
  folder.add_json("summary.json", summary_json(findings));
  folder.add("report.html", report_page(findings, maps));
  folder.commit();
}

}  // namespace

ExitCode inspect(const CommandLine& command_line, const CommonOptions& common) {
  const Options options = command_line.options();
  const energies::AnyEnergy energy = with_error_kind(ErrorKind::misuse, [&] { return read_energy(options); });
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  const Findings findings = look_at(energy, options);
  print(report_text(findings));
  if (!folder) return ExitCode::success;
  write(findings, *folder);
  return conclude(verdict(findings), ExitCode::success, *folder, options.out, common.verbose);
}

}  // namespace isostretch::app::inspect

#include "command_line.hpp"

#include <isostretch/core/numbers.hpp>
#include "common/exit_code.hpp"
#include "common/validators.hpp"

#include <isostretch/scene/energy_choice.hpp>

#include <CLI/CLI.hpp>

#include <iostream>

namespace isostretch::app::inspect {
namespace {

Range parse_range(const std::string& text) {
  const auto ends = split(text, ':');
  const auto low = finite_number(ends[0]), high = finite_number(ends.back());
  if (ends.size() != 2 || !low || !high) throw Error("--range: '" + text + "' is not of the form LOW:HIGH");
  if (!(*low >= 1e-9 && *low < 1 && *high > 1 && *high <= 1e9))
    throw Error("--range: '" + text + "' must begin between 1e-9 and 1 and end between 1 and 1e9");
  return {*low, *high};
}

}  // namespace

void CommandLine::declare(CLI::App& cli) {
  cli.option_defaults()->group("Energy and results");
  cli.add_option("energy", energy_,
                 "Name of an energy (--list-energies shows all) or an expression such as 'mu/2*(I2-d) - "
                 "mu*log(J)'; one that begins with a minus goes after --")
      ->required()
      ->type_name("ENERGY");
  cli.add_option("-p,--param", parameters_,
                 "Parameters of the energy: name=value[,name=value...]; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  cli.add_option("--dim", dimensions_, "Of the body: " + listed(all_names(dimension_names)))
      ->check(one_of(all_names(dimension_names)))
      ->type_name("DIM")
      ->capture_default_str();
  cli.add_option("--range", range_, "Stretches to look at, around 1")
      ->type_name("LOW:HIGH")
      ->capture_default_str();
  cli.add_option("-o,--out", out_, "Folder for report.html, summary.json and pictures")->type_name("FOLDER");
  cli.add_flag_callback(
         "--list-energies",
         [] {
           std::cout << "In the plane:\n"
                     << scene::energy_table(2) << "\nIn space:\n"
                     << scene::energy_table(3) << std::flush;
           throw CLI::Success{};
         },
         "List the energies and their parameters, and exit")
      ->trigger_on_parse();
}

Options CommandLine::options() const {
  return with_error_kind(ErrorKind::misuse, [this] {
    Options options;
    options.energy = energy_;
    options.parameters = scene::parse_parameters(parameters_);
    options.dimensions = choice_of(dimension_names, dimensions_);
    options.range = parse_range(range_);
    options.out = out_;
    return options;
  });
}

}  // namespace isostretch::app::inspect

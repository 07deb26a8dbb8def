#include "command_line.hpp"

#include "common/energy_choice.hpp"
#include "common/exit_code.hpp"
#include "common/look_flags.hpp"
#include "common/validators.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

namespace isostretch::app::interpolate {
namespace {

std::string energy_list() {
  return "In space:\n" + energy_table(3) + "\nIn the plane:\n" + listed(energy_names_in(2)) + "\n";
}

}  // namespace

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  declare_energy(cli);
  solver_flags_.declare(cli);
  // Others than in the other apps.
  cli.get_option("--projection")
      ->default_str(std::string(newton::projection_name(defaults_.newton.projection)));
  cli.get_option("--ordering")
      ->default_str(std::string(sparse::ordering_name(defaults_.newton.solver.ordering)));
}

void CommandLine::declare_files(CLI::App& cli) {
  cli.option_defaults()->group("Files");
  cli.add_option("first", first_, "First pose: solid elements (MSH, MESH, VTK, VTU, NODE) or a flat surface")
      ->required()
      ->type_name("FILE");
  cli.add_option("second", second_,
                 "Second pose: the same vertices and elements in the same order, elsewhere")
      ->required()
      ->type_name("FILE");
  cli.add_option("-o,--out", out_,
                 "Folder for all results: frames, summary.json, trace.csv, pictures, report.html. Required "
                 "but for --check")
      ->type_name("FOLDER");
  declare_check(cli, check_, true);
  cli.add_option("--frames", frames_, "Number of steps from the first pose to the second")
      ->check(whole_number_between(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
  repair_flags_.declare(cli);
  declare_frames(cli, frame_flags_, "interpolation.glb");
}

void CommandLine::declare_energy(CLI::App& cli) {
  cli.option_defaults()->group("Energy and start");
  cli.add_option("-e,--energy", energy_,
                 "Distortion energy that the frames minimise; --list-energies shows all")
      ->type_name("NAME")
      ->capture_default_str();
  cli.add_option("-p,--param", parameters_,
                 "Set parameters of the energy: name=value[,name=value...]; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  cli.add_flag_callback(
         "--list-energies",
         [] {
           std::cout << energy_list() << std::flush;
           throw CLI::Success{};
         },
         "List the energies and their parameters, and exit")
      ->trigger_on_parse();
  cli.add_option("--guess", guess_,
                 "Shape that the solver starts every frame from: " + listed(all_names(guess_names)))
      ->check(one_of(all_names(guess_names)))
      ->type_name("NAME")
      ->capture_default_str();
}

Options CommandLine::options() const {
  return with_error_kind(ErrorKind::misuse, [this] {
    Options options = defaults_;
    options.first = first_;
    options.second = second_;
    options.out = out_;
    options.check = check_;
    if (out_.empty() && !check_) throw Error("--out: a folder for the results is needed");
    options.repair = repair_flags_.repair();
    options.frames = frames_;
    options.energy = energy_;
    options.parameters = parse_parameters(parameters_);
    options.guess = choice_of(guess_names, guess_);
    if (frame_flags_.format) options.format = choice_of(frame_format_names, *frame_flags_.format);
    options.pictures = !frame_flags_.no_picture;
    options.glb = frame_flags_.glb;
    solver_flags_.apply(options.newton);
    // A gradient that was asked for is the only test.
    if (options.newton.gradient_tolerance > 0) options.newton.relative_energy_tolerance = 0;
    return options;
  });
}

}  // namespace isostretch::app::interpolate

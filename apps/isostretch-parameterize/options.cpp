#include "options.hpp"

#include "common/exit_code.hpp"
#include "common/numbers.hpp"
#include "energy_choice.hpp"
#include "pin_text.hpp"

#include <isostretch/sparse/solver.hpp>

#include <iostream>

namespace isostretch::app::parameterize {

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  declare_energy(cli);
  declare_pins(cli);
  declare_solve(cli);
}

void CommandLine::declare_files(CLI::App& cli) {
  cli.add_option("model", model_, "Surface to flatten: OBJ or OFF, a disk or a closed surface of genus 0")
      ->required()
      ->type_name("FILE");
  cli.add_option("-o,--out", out_, "Folder for <model>_uv.obj, summary.json, trace.csv, layout.png")
      ->required()
      ->type_name("FOLDER");
  cli.add_flag("--triangulate", triangulate_, "Cut faces of more than three corners into fans");
  cli.add_flag("--no-cut", no_cut_, "Refuse a closed surface instead of cutting it open");
  cli.add_flag("--keep-normalized", keep_normalized_, "Write uv for total area 1, not in the model's units");
  cli.add_flag("--no-picture", no_picture_, "Do not draw layout.png");
}

void CommandLine::declare_energy(CLI::App& cli) {
  cli.add_option("-e,--energy", energy_, "Distortion energy; --list-energies shows all")
      ->type_name("NAME")
      ->capture_default_str();
  cli.add_option("-p,--param", parameters_,
                 "Parameters of the energy: name=value[,name=value...]; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  cli.add_flag_callback(
         "--list-energies",
         [] {
           std::cout << energy_table() << std::flush;
           throw CLI::Success{};
         },
         "List the energies and their parameters, and exit")
      ->trigger_on_parse();
}

void CommandLine::declare_pins(CLI::App& cli) {
  cli.add_option("--pin", pins_,
                 "Keep a vertex (counted from 0) in its initial place, or put it at U,V; may be "
                 "repeated")
      ->allow_extra_args(false)
      ->type_name("VERTEX[:U,V]");
  cli.add_option("--soft-pin", soft_pins_, "Pull a vertex towards U,V with a weight (1); may be repeated")
      ->allow_extra_args(false)
      ->type_name("VERTEX:U,V[:WEIGHT]");
}

void CommandLine::declare_solve(CLI::App& cli) {
  cli.add_option("--initial", initial_, "Start from Tutte's embedding or the input's uv: tutte, input")
      ->check(CLI::IsMember({"tutte", "input"}))
      ->type_name("START")
      ->capture_default_str();
  cli.add_option("--projection", projection_, "How the Hessian is made definite: adaptive, clamp, abs, none")
      ->check(CLI::IsMember(newton::projection_names()))
      ->type_name("NAME")
      ->capture_default_str();
  cli.add_option(
         "--grad-tol", gradient_tolerance_,
         "Stop at |gradient|_inf <= this, with total area 1; default: a test that adapts to the scale")
      ->check(positive())
      ->type_name("X");
  cli.add_option("--max-iterations", max_iterations_, "Stop after so many")
      ->check(whole_number_between(0, 1'000'000'000))
      ->type_name("N")
      ->capture_default_str();
  cli.add_option("--max-expansion", max_expansion_,
                 "Lengthen steps that gain more than promised up to this; 1: never")
      ->check(CLI::Range(1.0, 1e6))
      ->type_name("X")
      ->capture_default_str();
  cli.add_option("--time-limit", time_limit_, "Stop after so many seconds; 0: no limit")
      ->check(not_negative())
      ->type_name("SECONDS");
  cli.add_option("--solver", solver_, "automatic, cholmod_supernodal, cholmod_simplicial, eigen_ldlt, pcg")
      ->type_name("NAME")
      ->capture_default_str();
  cli.add_option("--ordering", ordering_, "automatic, amd, metis, natural")
      ->type_name("NAME")
      ->capture_default_str();
}

namespace {

newton::Options solve_options(const std::string& projection, const std::optional<double>& gradient_tolerance,
                              const std::string& solver, const std::string& ordering) {
  newton::Options options;
  options.projection = newton::projection_from_name(projection);
  if (gradient_tolerance) {
    options.gradient_tolerance = *gradient_tolerance;
    options.scaled_gradient_tolerance = 0;  // what was asked for is what counts
  }
  options.solver.backend = sparse::backend_from_name(solver);
  options.solver.ordering = sparse::ordering_from_name(ordering);
  sparse::make_solver(options.solver);  // says at once when it is not compiled in
  return options;
}

}  // namespace

Options CommandLine::options() const {
  return failing_with(ExitCode::command_line, [this] {
    Options options;
    options.model = model_;
    options.out = out_;
    options.initial = initial_ == "input" ? Initial::input : Initial::tutte;
    options.triangulate = triangulate_;
    options.cut = !no_cut_;
    options.keep_normalized = keep_normalized_;
    options.picture = !no_picture_;
    options.pins = parse_pins(pins_);
    options.soft_pins = parse_soft_pins(soft_pins_);
    options.newton = solve_options(projection_, gradient_tolerance_, solver_, ordering_);
    options.newton.max_iterations = max_iterations_;
    options.newton.time_limit = time_limit_;
    options.newton.max_expansion = max_expansion_;
    if (options.out.empty()) throw Error("--out: the name of the folder is empty");
    return options;
  });
}

energies::AnyEnergy CommandLine::energy() const {
  return failing_with(ExitCode::command_line, [this] { return choose_energy(energy_, parameters_); });
}

}  // namespace isostretch::app::parameterize

#include "command_line.hpp"

#include "common/energy_choice.hpp"
#include "common/exit_code.hpp"
#include "common/handle_text.hpp"
#include "common/json_value.hpp"
#include "common/validators.hpp"
#include "scene.hpp"
#include "scene_reader.hpp"

#include <isostretch/deformation/material.hpp>

#include <CLI/CLI.hpp>

#include <iostream>

namespace isostretch::app::deform {
namespace {

std::string energy_list() {
  return "In space:\n" + energy_table(3) + "\nIn the plane:\n" + listed(energy_names_in(2)) +
         "\n\nWith --young and --poisson:\n" + listed(deformation::energies_with_material()) + "\n";
}

}  // namespace

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  declare_scene(cli);
  solver_flags_.declare(cli);
}

void CommandLine::declare_files(CLI::App& cli) {
  cli.option_defaults()->group("Files");
  std::string input_help =
      "Body: solid elements (MSH, MESH, VTK, VTU, NODE) or a flat surface; or a scene (JSON), which names "
      "body and handles";
  cli.add_option("input", input_, input_help)->required()->type_name("FILE");
  cli.add_option("-o,--out", out_,
                 "Folder for all results: frames, summary.json, trace.csv, deform.png, report.html. Required "
                 "but for --check")
      ->type_name("FOLDER");
  declare_look(cli, look_);
  auto* restart = cli.add_flag("--restart", restart_,
                               "Go on after the last good frame in --out, for a run that was stopped");
  restart->excludes(cli.get_option("--check"))->excludes(cli.get_option("--preview"));
  cli.add_option("--stop-after", stop_after_,
                 "End this run after so many frames, to go on with --restart later")
      ->check(whole_number_between(0, 1'000'000))
      ->type_name("N");
  repair_flags_.declare(cli);
  declare_frames(cli, frame_flags_, "deform.glb");
  cli.get_option("--no-picture")->excludes(cli.get_option("--preview"));
}

void CommandLine::declare_scene(CLI::App& cli) {
  cli.option_defaults()->group("Scene");
  cli.add_option("-e,--energy", energy_,
                 "Distortion energy that is minimised: how the body resists; --list-energies shows all")
      ->type_name("NAME")
      ->default_str("arap");
  cli.add_option("-p,--param", parameters_,
                 "Set parameters of the energy: name=value[,name=value...]; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  cli.add_option("--young", young_,
                 "Young's modulus: how stiff the material is. With --poisson it sets the parameters of an "
                 "energy that is a material")
      ->check(positive())
      ->type_name("E");
  cli.add_option(
         "--poisson", poisson_,
         "Poisson's ratio: how much the material thins when it is stretched; near 0.5 it keeps its volume")
      ->check(number_between(-1.0, 0.5))
      ->type_name("NU");
  cli.add_flag_callback(
         "--list-energies",
         [] {
           std::cout << energy_list() << std::flush;
           throw CLI::Success{};
         },
         "List the energies and their parameters, and exit")
      ->trigger_on_parse();
  cli.add_option("--handle", handles_, handle_help(Holding::hard))
      ->allow_extra_args(false)
      ->type_name("HANDLE");
  cli.add_option(
         "--frames", frames_,
         "Number of steps from rest to the end of the motion. More are slower and survive larger motions")
      ->check(whole_number_between(1, 1'000'000))
      ->type_name("N")
      ->default_str(std::to_string(10));
  cli.add_option("--guess", guess_,
                 "Shape that the solver starts every frame from: " +
                     listed(all_names(deformation::initial_guess_names)))
      ->check(one_of(all_names(deformation::initial_guess_names)))
      ->type_name("NAME")
      ->default_str(name_of(deformation::initial_guess_names, InitialGuess::biharmonic));
  cli.add_option(
         "--order", order_,
         "2 makes quadratic elements of the linear ones in the file: slower, but bending is not too stiff")
      ->check(whole_number_between(1, 2))
      ->type_name("N");
  cli.add_option("--quadrature", quadrature_,
                 "Degree of the polynomials that are integrated exactly over an element; higher is slower "
                 "and more exact")
      ->check(whole_number_between(1, 5))
      ->type_name("N");
}

MeshRepair CommandLine::repair() const {
  return with_error_kind(ErrorKind::misuse, [this] { return repair_flags_.repair(); });
}

Options CommandLine::options() const {
  return with_error_kind(ErrorKind::misuse, [this] {
    Options options;
    options.out = out_;
    options.look = look_;
    if (out_.empty() && !look_.check) throw Error("--out: a folder for the results is needed");
    options.restart = restart_;
    options.stop_after = stop_after_;
    options.picture = !frame_flags_.no_picture;
    options.glb = frame_flags_.glb;
    newton::Options newton;
    solver_flags_.apply(newton);
    options.time_limit = newton.time_limit;
    return options;
  });
}

void CommandLine::add_energy(Json& scene) const {
  const auto parameters =
      with_error_kind(ErrorKind::misuse, [this] { return parse_parameters(parameters_); });
  if (energy_) scene["energy"] = *energy_;
  if (!scene.contains("energy")) scene["energy"] = "arap";
  if (!parameters.empty()) {
    if (scene["energy"].is_string()) scene["energy"] = Json{{"name", scene["energy"]}};
    for (const auto& [name, value] : parameters) scene["energy"]["parameters"][name] = value;
  }
  if (young_.has_value() != poisson_.has_value())
    throw Error(ErrorKind::misuse, "--young and --poisson go together");
  if (young_) scene["material"] = Json{{"young", *young_}, {"poisson", *poisson_}};
}

void CommandLine::add_handles(Json& scene) const {
  with_error_kind(ErrorKind::misuse, [&] {
    for (const std::string& text : handles_)
      scene["handles"].push_back(handle_from_text(text, Holding::hard));
    if (has_scene_file() || look_.check) return;  // what it lacks is said when its turn comes
    if (!scene.contains("handles")) throw Error("--handle: there must be one at least");
  });
}

Json CommandLine::scene() const {
  Json scene = scene_object(input_, scene_keys());
  if (!has_scene_file()) scene["mesh"] = input_.string();
  try {
    add_energy(scene);
    add_handles(scene);
  } catch (const Json::exception&) {
    throw Error(ErrorKind::input,
                input_.string() + ": energy or handles are nothing that the command line could add to");
  }
  if (frames_) scene["frames"] = *frames_;
  if (guess_) scene["guess"] = *guess_;
  if (frame_flags_.format) scene["format"] = *frame_flags_.format;
  if (order_) scene["order"] = *order_;
  if (quadrature_) scene["quadrature"] = *quadrature_;
  newton::Options newton = with_error_kind(ErrorKind::input, [&] {
    return with_error_prefix(input_.string(), [&] { return read_solver(scene); });
  });
  with_error_kind(ErrorKind::misuse, [&] { solver_flags_.apply(newton); });
  scene["solver"] = solver_json(newton);
  return scene;
}

}  // namespace isostretch::app::deform

#include "command_line.hpp"

#include "common/exit_code.hpp"
#include "common/validators.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/deformation/material.hpp>
#include <isostretch/newton/options.hpp>
#include <isostretch/scene/handle_text.hpp>

#include <CLI/CLI.hpp>

namespace isostretch::app::deform {
namespace {

// Keys of a scene that this app has a use for.
const std::vector<std::string> used_keys{"schema", "mesh",          "order",   "quadrature",
                                         "energy", "material",      "regions", "handles",
                                         "frames", "initial_guess", "format",  "newton"};

}  // namespace

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  declare_scene(cli);
  cli.option_defaults()->group("Solver");
  newton::Options newton;
  option_flags_.declare(cli, option_fields(newton), "newton");
  option_flags_.declare_set(cli);
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
      ->check(in_range(between(0, 1'000'000), true))
      ->type_name("N");
  repair_flags_.declare(cli);
  option_flags_.declare_key(cli, "format");
  declare_frames(cli, frame_flags_, "deform.glb");
  cli.get_option("--no-picture")->excludes(cli.get_option("--preview"));
}

void CommandLine::declare_scene(CLI::App& cli) {
  cli.option_defaults()->group("Scene");
  energy_flags_.declare(cli, "Distortion energy that is minimised: how the body resists", "arap", [] {
    return energy_list() + "\nWith --young and --poisson:\n" + listed(deformation::energies_with_material()) +
           "\n";
  });
  cli.add_option("--young", young_,
                 "Young's modulus: how stiff the material is. With --poisson it sets the parameters of an "
                 "energy that is a material")
      ->check(in_range(above(0), false))
      ->type_name("E");
  cli.add_option(
         "--poisson", poisson_,
         "Poisson's ratio: how much the material thins when it is stretched; near 0.5 it keeps its volume")
      ->check(in_range(between(-1.0, 0.5), false))
      ->type_name("NU");
  cli.add_option("--handle", handles_, scene::handle_help(scene::Holding::hard))
      ->allow_extra_args(false)
      ->type_name("HANDLE");
  option_flags_.declare_key(cli, "frames", "10");
  for (const char* key : {"initial_guess", "order", "quadrature"}) option_flags_.declare_key(cli, key);
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
    return options;
  });
}

void CommandLine::add_handles(scene::Value& scene) const {
  with_error_kind(ErrorKind::misuse, [&] {
    if (!handles_.empty() && scene.has("handles") && !scene["handles"].is_list())
      throw Error(ErrorKind::input, input_.string() + ": handles: are no list that --handle could add to");
    for (const std::string& text : handles_) scene["handles"].push_back(scene::handle_from_text(text));
    if (has_scene_file() || look_.check) return;  // what it lacks is said when its turn comes
    if (!scene.has("handles")) throw Error("--handle: there must be one at least");
  });
}

scene::Value CommandLine::scene() const {
  scene::Value scene = read_scene_input(input_, used_keys);
  if (!has_scene_file()) scene["mesh"] = input_.string();
  energy_flags_.add_to(scene, input_);
  if (young_.has_value() != poisson_.has_value())
    throw Error(ErrorKind::misuse, "--young and --poisson go together");
  if (young_) scene["material"] = scene::Value::object({{"young", *young_}, {"poisson", *poisson_}});
  add_handles(scene);
  option_flags_.add_to(scene);
  return scene;
}

}  // namespace isostretch::app::deform

#include "command_line.hpp"

#include "common/exit_code.hpp"
#include "common/scene_input.hpp"

#include <isostretch/scene/energy.hpp>
#include <isostretch/scene/energy_choice.hpp>
#include <isostretch/scene/pipelines.hpp>

#include <CLI/CLI.hpp>

#include <vector>

namespace isostretch::app::parameterize {
namespace {

// Keys of a scene that this app has a use for.
const std::vector<std::string> used_keys{"schema", "mesh", "energy", "parameterization", "newton"};

}  // namespace

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  parameterization::Options options;
  cli.option_defaults()->group("Cutting and layout");
  option_flags_.declare(cli, scene::parameterization_fields(options), "parameterization");
  cli.add_option("--corners", pins_.corners,
                 "Four vertices of the boundary for the corners of --boundary square, in order")
      ->type_name("A,B,C,D");
  cli.option_defaults()->group("Energy");
  energy_flags_.declare(cli, "Distortion energy", "symmetric_dirichlet",
                        [] { return scene::energy_table(2); });
  declare_pins(cli);
  cli.option_defaults()->group("Solver");
  option_flags_.declare(cli, option_fields(options.newton), "newton");
  option_flags_.declare_set(cli);
}

void CommandLine::declare_files(CLI::App& cli) {
  cli.option_defaults()->group("Files");
  cli.add_option("model", input_,
                 "Surface to flatten: OBJ, OFF, PLY, STL, MSH, MESH, VTK or VTU; or a scene (JSON)")
      ->required()
      ->type_name("FILE");
  cli.add_option("-o,--out", out_,
                 "Folder for <model>_uv.obj, summary.json, trace.csv, report.html and pictures")
      ->type_name("FOLDER");
  cli.add_flag("--check", check_,
               "Only print what is wrong with the model, element by element, and its topology");
  cli.add_flag("--triangulate", triangulate_,
               "Accepted for old scripts: faces of more than three corners are always cut");
  cli.add_flag(
      "--repair", repair_,
      "Orient triangles alike, drop duplicate and degenerate ones, split vertices where sheets touch");
  weld_option_ = declare_weld(cli, weld_);
  cli.add_flag("--no-picture", no_picture_,
               "Do not draw pictures, and write no report.html, which shows them");
  cli.add_flag("--glb", glb_, "Also write <model>_uv.glb with a checkerboard as texture");
}

void CommandLine::declare_pins(CLI::App& cli) {
  cli.option_defaults()->group("Pins");
  cli.add_option("--pin", pins_.hard,
                 "Keep a vertex (counted from 0) in its initial place, or put it at U,V; may be "
                 "repeated")
      ->allow_extra_args(false)
      ->type_name("VERTEX[:U,V]");
  cli.add_option("--soft-pin", pins_.soft, "Pull a vertex towards U,V with a weight (1); may be repeated")
      ->allow_extra_args(false)
      ->type_name("VERTEX:U,V[:WEIGHT]");
  cli.add_option("--horizontal", pins_.horizontal,
                 "Vertices that come to lie at the same v, an edge or more; may be repeated")
      ->allow_extra_args(false)
      ->type_name("A,B[,C...]");
  cli.add_option("--vertical", pins_.vertical, "The same at the same u")
      ->allow_extra_args(false)
      ->type_name("A,B[,C...]");
}

scene::Value CommandLine::scene() const {
  scene::Value scene = read_scene_input(input_, used_keys);
  if (!is_scene_file(input_)) scene["mesh"] = input_.string();
  energy_flags_.add_to(scene, input_);
  with_error_kind(ErrorKind::misuse, [&] { scene::add_pins(pins_, scene); });
  option_flags_.add_to(scene);
  return scene;
}

Options CommandLine::options() const {
  const scene::Value value = scene();
  Options options{{}, reading_scene(input_, [&] { return scene::read_energy(scene::Node(value), 2); })};
  reading_scene(input_, [&] {
    const scene::Node scene(value);
    static_cast<parameterization::Options&>(options) = scene::read_parameterization(scene);
    options.model = scene_folder(input_) / scene.at("mesh").text();
  });
  options.out = out_;
  options.check = check_;
  options.repair = repair_;
  options.picture = !no_picture_;
  options.glb = glb_;
  with_error_kind(ErrorKind::misuse, [&] {
    options.weld = weld_tolerance(weld_option_, weld_);
    if (options.out.empty() && !options.check) throw Error("--out: a folder for the results is needed");
  });
  return options;
}

}  // namespace isostretch::app::parameterize

#include "command_line.hpp"

#include "common/exit_code.hpp"
#include "common/look_flags.hpp"
#include "common/scene_input.hpp"

#include <isostretch/scene/pipelines.hpp>

#include <CLI/CLI.hpp>

namespace isostretch::app::interpolate {
namespace {

// Keys of a scene that this app has a use for.
const std::vector<std::string> used_keys{"schema", "mesh",   "second_mesh",   "energy",
                                         "frames", "format", "interpolation", "newton"};

}  // namespace

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  cli.option_defaults()->group("Energy and start");
  energy_flags_.declare(cli, "Distortion energy that the frames minimise", "symmetric_arap", energy_list);
  deformation::InterpolationOptions options;
  option_flags_.declare(cli, scene::interpolation_fields(options), "interpolation");
  cli.option_defaults()->group("Solver");
  option_flags_.declare(cli, option_fields(options.newton), "newton");
  option_flags_.declare_set(cli);
}

void CommandLine::declare_files(CLI::App& cli) {
  cli.option_defaults()->group("Files");
  cli.add_option("first", first_,
                 "First shape: solid elements (MSH, MESH, VTK, VTU, NODE) or a flat surface; or a scene "
                 "(JSON), which names both")
      ->required()
      ->type_name("FILE");
  cli.add_option("second", second_,
                 "Second shape: the same vertices and elements in the same order, elsewhere")
      ->type_name("FILE");
  cli.add_option("-o,--out", out_,
                 "Folder for all results: frames, summary.json, trace.csv, pictures, report.html. Required "
                 "but for --check")
      ->type_name("FOLDER");
  declare_check(cli, check_, true);
  option_flags_.declare_key(cli, "frames", "10");
  repair_flags_.declare(cli);
  option_flags_.declare_key(cli, "format");
  declare_frames(cli, frame_flags_, "interpolation.glb");
}

scene::Value CommandLine::scene() const {
  scene::Value scene = read_scene_input(first_, used_keys);
  if (!is_scene_file(first_)) scene["mesh"] = first_.string();
  if (!second_.empty())
    scene["second_mesh"] = is_scene_file(first_) ? std::filesystem::absolute(second_).string() : second_;
  energy_flags_.add_to(scene, first_);
  option_flags_.add_to(scene);
  return scene;
}

Options CommandLine::options() const {
  Options options;
  options.value = scene();
  with_error_kind(ErrorKind::misuse, [&] {
    if (!options.value.has("second_mesh") && !is_scene_file(first_))
      throw Error("second: a second shape is needed");
    if (out_.empty() && !check_) throw Error("--out: a folder for the results is needed");
    options.repair = repair_flags_.repair();
  });
  reading_scene(first_, [&] {
    const scene::Node scene(options.value);
    static_cast<deformation::InterpolationOptions&>(options) = scene::read_interpolation(scene);
    options.first = scene_folder(first_) / scene.at("mesh").text();
    options.second = scene_folder(first_) / scene.at("second_mesh").text();
    if (const auto format = scene.find("format"))
      options.format = format->choice(choice_names(FrameFormat{}));
  });
  options.out = out_;
  options.check = check_;
  options.pictures = !frame_flags_.no_picture;
  options.glb = frame_flags_.glb;
  return options;
}

}  // namespace isostretch::app::interpolate

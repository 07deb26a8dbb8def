#include "command_line.hpp"

#include <isostretch/core/numbers.hpp>
#include "common/exit_code.hpp"
#include "common/scene_input.hpp"
#include "common/validators.hpp"

#include <isostretch/baselines/distortion.hpp>
#include <isostretch/comparison/method_scene.hpp>
#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/figures/utf8.hpp>
#include <isostretch/scene/energy_choice.hpp>
#include <isostretch/scene/scene_file.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

namespace isostretch::app::compare {
namespace {

// Keys of a scene that this app has a use for.
const std::vector<std::string> used_keys{"schema", "problems", "methods", "limits", "repetitions"};

// One line a method, as --list-methods prints it.
std::string method_table() {
  std::string table;
  for (const baselines::MethodInfo& info : baselines::methods())
    table.append(info.name).append("  ").append(info.title).append(", ").append(info.source).append("\n");
  return table;
}

using Parameters = std::map<std::string, double>;

std::string without_odd_characters(std::string name) {
  for (char& c : name)
    if (!comparison::may_be_in_name(c)) c = '_';
  return name;
}

// The file's name with the energy's; numbered where that is taken.
std::string unused_name(const std::string& mesh, const std::string& energy, std::set<std::string>& taken) {
  const std::string name = without_odd_characters(std::filesystem::path(mesh).stem().string() + "_" + energy);
  std::string unused = name;
  for (int number = 2; !taken.insert(unused).second; ++number) unused = name + "_" + std::to_string(number);
  return unused;
}

}  // namespace

void CommandLine::declare(CLI::App& cli) {
  declare_problems(cli);
  declare_methods(cli);
  declare_single_run(cli);
}

void CommandLine::declare_problems(CLI::App& cli) {
  cli.option_defaults()->group("Problems and results");
  auto* meshes =
      cli.add_option("mesh", meshes_, "Surfaces to flatten, disks: OBJ, OFF, PLY, STL, MSH, MESH, VTK or VTU")
          ->type_name("MESH");
  energy_flags_.declare(cli, "Energies of the meshes, several with commas", "symmetric_dirichlet", [] {
    return "In the plane:\n" + scene::energy_table(2) + "\nIn space (scenes):\n" + scene::energy_table(3);
  });
  auto* scene = cli.add_option("--scene", scene_file_,
                               "Instead of meshes: problems and settings (JSON), or the name of a scene that "
                               "comes with the program");
  take_scene_names(*scene, embedded_scenes());
  declare_scene_list(cli, embedded_scenes());
  scene->excludes(meshes)->excludes("--energy")->excludes("--param")->type_name("FILE");
  cli.add_option("-o,--out", out_, "Folder for report.html, comparison.json, tables, plots, and all runs")
      ->required()
      ->type_name("FOLDER");
  cli.add_flag("--no-picture", no_picture_, "Draw no plots");
}

void CommandLine::declare_methods(CLI::App& cli) {
  cli.option_defaults()->group("Methods and limits");
  cli.add_option("-m,--method", methods_, "These only, names with commas; --list-methods shows all")
      ->type_name("NAME[,NAME...]")
      ->default_str("all");
  cli.add_flag_callback(
         "--list-methods",
         [] {
           std::cout << method_table() << std::flush;
           throw CLI::Success{};
         },
         "List the methods, and exit")
      ->trigger_on_parse();
  scene::ComparisonLimits limits;
  option_flags_.declare(cli, option_fields(limits), "limits");
  option_flags_.declare_key(cli, "repetitions");
  option_flags_.declare_set(cli);
}

void CommandLine::declare_single_run(CLI::App& cli) {
  const char* group = "One run, as the program calls itself";
  auto* scene = cli.get_option("--scene");
  auto* run =
      cli.add_option("--run", run_, "Run the one --method on this problem of the scene; no comparison")
          ->needs(scene)
          ->needs(cli.get_option("--method"))
          ->type_name("PROBLEM")
          ->group(group);
  cli.add_option("--from", from_, "Start there instead: positions.bin of another run")
      ->needs(run)
      ->type_name("FILE")
      ->group(group);
}

void CommandLine::add_problems(scene::Value& scene) const {
  const Parameters parameters = scene::parse_parameters(energy_flags_.parameters());
  Parameters unused = parameters;
  std::set<std::string> taken;
  for (const std::string& mesh : meshes_) {
    // Runs find their problems in a scene, which is JSON.
    if (figures::valid_utf8(mesh) != mesh)
      throw Error("a mesh's path must be UTF-8 here: " + figures::valid_utf8(mesh));
    for (const std::string& energy : scene::split_energies(energy_flags_.name())) {
      const auto own =
          with_error_prefix("--energy", [&] { return scene::parameters_of(energy, parameters); });
      for (const auto& [name, value] : own) unused.erase(name);
      scene::Value values = scene::Value::object();
      for (const auto& [name, value] : own) values[name] = value;
      scene["problems"].push_back(scene::Value::object(
          {{"name", unused_name(mesh, energy, taken)},
           {"mesh", std::filesystem::absolute(mesh).string()},
           {"energy", scene::Value::object({{"name", energy}, {"parameters", values}})}}));
    }
  }
  if (!unused.empty())
    throw Error("--param: none of the energies has a parameter '" + unused.begin()->first + "'");
}

scene::Value CommandLine::scene() const {
  scene::Value scene = read_scene_input(scene_file_, used_keys, embedded_scenes());
  if (!scene_file_.empty() && !is_scene_file(scene_file_))
    throw Error(ErrorKind::misuse, "--scene: a scene is FILE.json, not '" + scene_file_.string() + "'");
  if (scene_file_.empty()) {
    if (meshes_.empty())
      throw Error(ErrorKind::misuse, "there is nothing to compare on: give a mesh, or --scene");
    with_error_kind(ErrorKind::misuse, [&] { add_problems(scene); });
  }
  if (methods_) {
    const std::vector<std::string> names = split(*methods_, ',');
    scene["methods"] = scene::Value::list({names.begin(), names.end()});
  }
  option_flags_.add_to(scene);
  return scene;
}

Options CommandLine::options(const scene::Value& scene) const {
  if (methods_)
    with_error_kind(ErrorKind::misuse, [&] {
      return with_error_prefix("--method", [&] { return comparison::choose_methods(split(*methods_, ',')); });
    });
  Options options{reading_scene(scene_file_, [&] { return comparison::read_comparison_settings(scene); }),
                  out_, !no_picture_};
  return options;
}

SingleRun CommandLine::single_run() const {
  SingleRun run;
  const Options all = options(scene());
  if (all.methods.size() != 1) throw Error(ErrorKind::misuse, "--run: takes one --method");
  run.problem = run_;
  run.method = all.methods.front();
  run.limits = all.limits;
  run.from = from_;
  run.out = all.out;
  return run;
}

}  // namespace isostretch::app::compare

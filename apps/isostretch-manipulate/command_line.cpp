#include "command_line.hpp"

#include "common/exit_code.hpp"
#include "common/validators.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/core/numbers.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/scene/handle_text.hpp>
#include <isostretch/scene/manipulation_scene.hpp>

#include <CLI/CLI.hpp>

namespace isostretch::app::manipulate {
namespace {

// Keys of a scene that this app has a use for.
const std::vector<std::string> used_keys{"schema",       "mesh",   "order", "quadrature",
                                         "handles",      "frames", "photo", "format",
                                         "manipulation", "rival",  "up"};

constexpr int most_frames = 1'000'000;

int frame_number(const std::string& text, const std::string& word) {
  const auto number = whole_number(word);
  if (!number || *number < 1 || *number > most_frames)
    throw Error("--frames: '" + text + "' is neither a number of frames nor FIRST:LAST");
  return *number;
}

}  // namespace

std::vector<std::string> rival_names() {
  std::vector<std::string> names;
  for (const baselines::SolverInfo& info : baselines::solvers()) names.emplace_back(info.name);
  return names;
}

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  declare_problem(cli);
  declare_rivals(cli);
  declare_photo(cli);
}

void CommandLine::declare_files(CLI::App& cli) {
  cli.option_defaults()->group("Files");
  auto* input = cli.add_option("input", input_,
                               "Body: tets (MSH, MESH, VTK, VTU, NODE) or a flat surface; or a scene (JSON), "
                               "which names body and handles; or the name of one of --list-scenes")
                    ->type_name("FILE");
  take_scene_names(*input, embedded_scenes());
  declare_scene_list(cli, embedded_scenes());
  cli.add_option("-o,--out", out_,
                 "Folder for all results: frames, summary.json, trace.csv, manipulate.png, path.png, "
                 "report.html. Required but for --check")
      ->type_name("FOLDER");
  declare_look(cli, look_);
  cli.add_option("--mesh", mesh_, "Take this body instead of the scene's, whose handles must fit it")
      ->type_name("FILE");
  cli.add_option("--refine", refine_,
                 "Make a generated body finer: so many times the cells in every direction")
      ->check(in_range(between(1, 10'000), true))
      ->type_name("K");
  cli.add_option("--weights-cache", weights_cache_,
                 "Keep handle weights in that folder, and take them from it: further runs with the same body "
                 "and handles begin faster")
      ->type_name("FOLDER");
  repair_flags_.declare(cli);
  option_flags_.declare_key(cli, "format");
  declare_frames(cli, frame_flags_, "manipulate.glb");
  cli.get_option("--no-picture")->excludes(cli.get_option("--preview"));
}

void CommandLine::declare_problem(CLI::App& cli) {
  cli.option_defaults()->group("Problem");
  cli.add_option("--handle", handles_, scene::handle_help(scene::Holding::soft))
      ->allow_extra_args(false)
      ->type_name("HANDLE");
  cli.add_option("--frames", frames_,
                 "N steps from rest to the end of the motion; or only the frames FIRST to LAST of the "
                 "scene's, to share them between machines")
      ->type_name("N|FIRST:LAST")
      ->default_str("1");
  deformation::ManipulationOptions options;
  option_flags_.declare(cli, option_fields(options), "manipulation");
  option_flags_.declare_set(cli);
}

void CommandLine::declare_rivals(CLI::App& cli) {
  cli.option_defaults()->group("Rivals and limits");
  cli.add_option("--rival", rival_,
                 "Solve with one of the rivals instead of --method: " + listed(rival_names()))
      ->check(one_of(rival_names()))
      ->type_name("NAME");
  auto* compare = cli.add_option("--compare", compare_,
                                 "Run many solvers on the last frame and compare their times and results: "
                                 "all, convex, alternative, or "
                                 "names with commas")
                      ->type_name("NAMES");
  for (const char* flag : {"--rival", "--method", "--penalty", "--relinearize", "--check", "--preview"})
    compare->excludes(cli.get_option(flag));
  cli.add_option("--repetitions", repetitions_,
                 "Run each solver of --compare so many times; the median counts")
      ->needs(compare)
      ->check(in_range(between(1, 1000), true))
      ->type_name("N")
      ->default_str("1");
  cli.add_option("--memory-limit", memory_limit_,
                 "End a rival, of --rival or --compare, that takes more megabytes; 0: no limit")
      ->check(in_range(at_least(0), false))
      ->type_name("MB");
  cli.add_option("--time-limit", time_limit_, "Stop after so many seconds; 0: no limit")
      ->check(in_range(at_least(0), false))
      ->type_name("SECONDS");
}

void CommandLine::declare_photo(CLI::App& cli) {
  cli.option_defaults()->group("Photograph");
  cli.add_option("--photo", photo_,
                 "Picture (PNG) that lies on a flat body and is drawn deformed with every frame")
      ->type_name("FILE");
  cli.add_option("--photo-cells", photo_cells_,
                 "Make the mesh: a grid over the picture, so many cells along its longer side")
      ->check(in_range(between(1, 100'000), true))
      ->type_name("N");
  cli.add_option("--photo-fit", photo_fit_,
                 "How the picture lies on the mesh: filling its box, or one unit a pixel: " +
                     listed(all_names(choice_names(scene::PhotoFit{}))))
      ->check(one_of(all_names(choice_names(scene::PhotoFit{}))))
      ->type_name("NAME")
      ->default_str("box");
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
    options.time_limit = time_limit_;
    options.memory_limit = memory_limit_;
    options.compare = compare_;
    options.repetitions = repetitions_;
    options.picture = !frame_flags_.no_picture;
    options.glb = frame_flags_.glb;
    options.weights_cache = weights_cache_;
    if (frames_ && frames_->find(':') != std::string::npos) {
      const auto ends = split(*frames_, ':');
      options.range = {frame_number(*frames_, ends[0]), frame_number(*frames_, ends[1])};
      if (ends.size() != 2 || options.range->last < options.range->first)
        throw Error("--frames: '" + *frames_ + "' is no range FIRST:LAST");
    }
    return options;
  });
}

// Files of a scene are sought from its folder, those of the command line from here.
std::string CommandLine::path_from_here(const std::string& file) const {
  return has_scene_file() ? std::filesystem::absolute(file).string() : file;
}

void CommandLine::add_mesh(scene::Value& scene) const {
  if (photo_cells_ && (mesh_ || (!input_.empty() && !has_scene_file())))
    throw Error(ErrorKind::misuse, "--photo-cells makes the mesh: give no other");
  if (!input_.empty() && !has_scene_file()) scene["mesh"] = input_.string();
  if (mesh_) scene["mesh"] = path_from_here(*mesh_);
  if (photo_cells_)
    scene["mesh"] = scene::Value::object("photo_grid", scene::Value::object("cells", *photo_cells_));
  if (!scene.has("mesh") && !has_scene_file())
    throw Error(ErrorKind::misuse, "there is no mesh: give a file, a scene, or --photo with --photo-cells");
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
  scene::Value scene = read_scene_input(input_, used_keys, embedded_scenes());
  add_mesh(scene);
  add_handles(scene);
  const auto photo = photo_ ? std::optional(path_from_here(*photo_)) : std::nullopt;
  scene::set_photo(scene, photo, photo_fit_);
  if (rival_) scene::set_rival(scene, *rival_);
  if (frames_ && frames_->find(':') == std::string::npos)
    scene["frames"] = with_error_kind(ErrorKind::misuse, [&] { return frame_number(*frames_, *frames_); });
  option_flags_.add_to(scene);
  return scene;
}

}  // namespace isostretch::app::manipulate

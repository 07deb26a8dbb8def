#include "command_line.hpp"

#include "common/exit_code.hpp"
#include "common/handle_text.hpp"
#include "common/json_value.hpp"
#include "common/numbers.hpp"
#include "common/validators.hpp"
#include "scene.hpp"
#include "scene_reader.hpp"

#include <isostretch/baselines/solver.hpp>

#include <CLI/CLI.hpp>

namespace isostretch::app::manipulate {
namespace {

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const sdp_penalty::Method method : sdp_penalty::all_methods())
    names.emplace_back(sdp_penalty::method_name(method));
  return names;
}

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const baselines::SolverInfo& info : baselines::solvers()) names.emplace_back(info.name);
  return names;
}

std::vector<std::string> penalty_names() {
  std::vector<std::string> names;
  for (const sdp_penalty::Penalty penalty : sdp_penalty::all_penalties())
    names.emplace_back(sdp_penalty::penalty_name(penalty));
  return names;
}

constexpr int most_frames = 1'000'000;

int frame_number(const std::string& text, const std::string& word) {
  const auto number = whole_number(word);
  if (!number || *number < 1 || *number > most_frames)
    throw Error("--frames: '" + text + "' is neither a number of frames nor FIRST:LAST");
  return *number;
}

template <class Choice, std::size_t N>
void add_choice(CLI::App& cli, const std::string& flag, std::optional<std::string>& value,
                const ChoiceNames<Choice, N>& names, const std::string& help, const std::string& otherwise) {
  cli.add_option(flag, value, help + listed(all_names(names)))
      ->check(one_of(all_names(names)))
      ->type_name("NAME")
      ->default_str(otherwise);
}

}  // namespace

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  declare_problem(cli);
  declare_solvers(cli);
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
      ->check(whole_number_between(1, 10'000))
      ->type_name("K");
  cli.add_option("--weights-cache", weights_cache_,
                 "Keep handle weights in that folder, and take them from it: further runs with the same body "
                 "and handles begin faster")
      ->type_name("FOLDER");
  repair_flags_.declare(cli);
  declare_frames(cli, frame_flags_, "manipulate.glb");
  cli.get_option("--no-picture")->excludes(cli.get_option("--preview"));
}

void CommandLine::declare_problem(CLI::App& cli) {
  cli.option_defaults()->group("Problem");
  cli.add_option("--handle", handles_, handle_help(Holding::soft))
      ->allow_extra_args(false)
      ->type_name("HANDLE");
  cli.add_option("--frames", frames_,
                 "N steps from rest to the end of the motion; or only the frames FIRST to LAST of the "
                 "scene's, to share them between machines")
      ->type_name("N|FIRST:LAST")
      ->default_str("1");
  cli.add_option(
         "--alpha", alpha_,
         "Weight of the soft handles against the distortion: more brings them closer to their targets")
      ->check(positive())
      ->type_name("X")
      ->default_str("1e4");
  cli.add_flag(
      "--absolute", absolute_,
      "Weigh handles by lengths of the mesh instead of shares of its diagonal, as published scenes do");
  add_choice(cli, "--weights", weights_, weights_names,
             "How much an element counts: its volume, or all the same: ",
             name_of(weights_names, ElementWeights::volume));
  cli.add_option("--incompressibility", incompressibility_,
                 "Weight of the term that keeps volume (kappa): above 0 for bodies like rubber or flesh")
      ->check(not_negative())
      ->type_name("X")
      ->default_str("0");
  cli.add_option("--margin", margin_,
                 "Keep lengths from shrinking below about this share (the least eigenvalue of S), against "
                 "elements that are all but flat; below 1")
      ->check(not_negative())
      ->check(number_between(0.0, 0.999999))
      ->type_name("X")
      ->default_str("0");
  cli.add_option("--largest-stretch", largest_stretch_,
                 "Forbid that a length grows by more than this factor, above 1; for --method interior_point")
      ->check(positive())
      ->check(number_between(1.000001, 1e300))
      ->type_name("X")
      ->default_str("none");
  cli.add_option("--relinearize", relinearize_,
                 "Solve again up to so many times, with the rotations of the result before, for shapes that "
                 "bend more naturally")
      ->check(whole_number_between(0, 1'000'000))
      ->type_name("N")
      ->default_str("0");
  add_choice(cli, "--rotations", rotations_, rotations_names,
             "Rotations that elements are to follow: blended smoothly from those of the handles, or none: ",
             name_of(rotations_names, Rotations::biharmonic));
  add_choice(cli, "--blend", blend_, blend_names,
             "How rotations of handles are blended: ", "angle in the plane, else quaternion");
}

void CommandLine::declare_solvers(CLI::App& cli) {
  cli.option_defaults()->group("Solver and rivals");
  cli.add_option("--method", method_, "Algorithm that solves the convex problem: " + listed(method_names()))
      ->check(one_of(method_names()))
      ->type_name("NAME")
      ->default_str(std::string(sdp_penalty::method_name(sdp_penalty::Options().method)));
  cli.add_option("--penalty", penalty_, "Penalty of --method penalty: " + listed(penalty_names()))
      ->check(one_of(penalty_names()))
      ->type_name("NAME")
      ->default_str(std::string(sdp_penalty::penalty_name(sdp_penalty::PenaltyOptions().penalty)));
  cli.add_option("--gap", gap_, "Stop when it is proved that no result is better by more than this share")
      ->check(positive())
      ->check(number_between(1e-16, 0.999999))
      ->type_name("X")
      ->default_str("1e-6");
  cli.add_option("--max-iterations", max_iterations_, "Stop a frame after so many iterations")
      ->check(whole_number_between(1, 1'000'000'000))
      ->type_name("N");
  cli.add_option("--solver", solver_,
                 "Solve with one of the rivals instead of --method: " + listed(solver_names()))
      ->check(one_of(solver_names()))
      ->type_name("NAME");
  auto* compare = cli.add_option("--compare", compare_,
                                 "Run many solvers on the last frame and compare their times and results: "
                                 "all, convex, nearby, or "
                                 "names with commas")
                      ->type_name("NAMES");
  for (const char* flag : {"--solver", "--method", "--penalty", "--relinearize", "--check", "--preview"})
    compare->excludes(cli.get_option(flag));
  cli.add_option("--repeat", repetitions_, "Run each solver of --compare so many times; the median counts")
      ->needs(compare)
      ->check(whole_number_between(1, 1000))
      ->type_name("N")
      ->default_str("1");
  cli.add_option("--memory-limit", memory_limit_,
                 "End a rival, of --solver or --compare, that takes more megabytes; 0: no limit")
      ->check(not_negative())
      ->type_name("MB");
  cli.add_option("--time-limit", time_limit_, "Stop after so many seconds; 0: no limit")
      ->check(not_negative())
      ->type_name("SECONDS");
}

void CommandLine::declare_photo(CLI::App& cli) {
  cli.option_defaults()->group("Photograph");
  cli.add_option("--photo", photo_,
                 "Picture (PNG) that lies on a flat body and is drawn deformed with every frame")
      ->type_name("FILE");
  cli.add_option("--photo-cells", photo_cells_,
                 "Make the mesh: a grid over the picture, so many cells along its longer side")
      ->check(whole_number_between(1, 100'000))
      ->type_name("N");
  add_choice(cli, "--photo-fit", photo_fit_, photo_fit_names,
             "How the picture lies on the mesh: filling its box, or one unit a pixel: ",
             name_of(photo_fit_names, PhotoFit::box));
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

void CommandLine::add_mesh(Json& scene) const {
  if (photo_cells_ && (mesh_ || (!input_.empty() && !has_scene_file())))
    throw Error(ErrorKind::misuse, "--photo-cells makes the mesh: give no other");
  if (!input_.empty() && !has_scene_file()) scene["mesh"] = input_.string();
  if (mesh_) scene["mesh"] = path_from_here(*mesh_);
  if (photo_cells_) scene["mesh"] = Json{{"photo_grid", {{"cells", *photo_cells_}}}};
  if (!scene.contains("mesh") && !has_scene_file())
    throw Error(ErrorKind::misuse, "there is no mesh: give a file, a scene, or --photo with --photo-cells");
}

void CommandLine::add_handles(Json& scene) const {
  with_error_kind(ErrorKind::misuse, [&] {
    for (const std::string& text : handles_)
      scene["handles"].push_back(handle_from_text(text, Holding::soft));
    if (has_scene_file() || look_.check) return;  // what it lacks is said when its turn comes
    if (!scene.contains("handles")) throw Error("--handle: there must be one at least");
  });
}

void CommandLine::add_photo(Json& scene) const {
  if (photo_) {
    scene["photo"] = Json{{"file", path_from_here(*photo_)}};
  } else if (photo_fit_ && scene.contains("photo") && scene["photo"].is_string()) {
    scene["photo"] = Json{{"file", scene["photo"]}};
  }
  if (!photo_fit_) return;
  if (!scene.contains("photo"))
    throw Error(ErrorKind::misuse, "--photo-fit says how a picture lies, and there is none");
  scene["photo"]["fit"] = *photo_fit_;
}

Json CommandLine::scene() const {
  Json scene = scene_object(input_, scene_keys(), embedded_scenes());
  add_mesh(scene);
  try {
    add_handles(scene);
    add_photo(scene);
  } catch (const Json::exception&) {
    throw Error(ErrorKind::input,
                input_.string() + ": handles or photo are nothing that the command line could add to");
  }
  if (frames_ && frames_->find(':') == std::string::npos)
    scene["frames"] = with_error_kind(ErrorKind::misuse, [&] { return frame_number(*frames_, *frames_); });
  if (alpha_) scene["alpha"] = *alpha_;
  if (absolute_) scene["units"] = name_of(units_names, LengthUnit::mesh);
  if (weights_) scene["weights"] = *weights_;
  if (incompressibility_) scene["incompressibility"] = *incompressibility_;
  if (margin_) scene["margin"] = *margin_;
  if (rotations_) scene["rotations"] = *rotations_;
  if (blend_) scene["blend"] = *blend_;
  if (method_) scene["method"] = *method_;
  if (penalty_) scene["penalty"] = *penalty_;
  if (solver_) {  // in the place of what the scene chose
    scene["solver"] = *solver_;
    if (!method_) scene.erase("method");
    if (!penalty_) scene.erase("penalty");
  }
  if (largest_stretch_) scene["largest_stretch"] = *largest_stretch_;
  if (relinearize_) scene["relinearize"] = *relinearize_;
  if (gap_) scene["gap"] = *gap_;
  if (max_iterations_) scene["max_iterations"] = *max_iterations_;
  if (frame_flags_.format) scene["format"] = *frame_flags_.format;
  return scene;
}

}  // namespace isostretch::app::manipulate

#pragma once

#include "common/embedded_scenes.hpp"
#include "common/exit_code.hpp"
#include "common/output_folder.hpp"

#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/scene/value.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace isostretch::app {

// The input of an app is a scene by its name; otherwise it is a mesh, and the command line says the rest.
inline bool is_scene_file(const std::filesystem::path& input) {
  return input.extension() == ".json";
}

// Where the files that a scene names are sought.
inline std::filesystem::path scene_folder(const std::filesystem::path& input) {
  return is_scene_file(input) ? input.parent_path() : std::filesystem::path();
}

/// Returns the scene in a file; where there is none of that name, the embedded scene of that name; an empty
/// one of the present schema when the input is a mesh. Older scenes are brought up to the present schema with
/// a notice, and keys that are none of `used`, which this app has no use for, are left out with a warning.
/// Throws Error naming the file, and for a name that is neither a file nor a scene.
scene::Value read_scene_input(const std::filesystem::path& input, const std::vector<std::string>& used,
                              const std::vector<EmbeddedScene>& embedded = {});

/// Lets the option take the name of an embedded scene: where there is no file of that name, NAME becomes
/// NAME.json, which is_scene_file() knows as a scene.
void take_scene_names(CLI::Option& option, const std::vector<EmbeddedScene>& embedded);

/// Declares --list-scenes, which prints every embedded scene with the first line of its comment, and ends.
void declare_scene_list(CLI::App& cli, const std::vector<EmbeddedScene>& embedded);

/// Returns the value as the reports' JSON.
Json report_json(const scene::Value& value);

// What a scene says wrong is the fault of its file, or of the command line when there is no such file; what
// is wrong in a mesh is that of the mesh in any case.
template <class Work>
auto reading_scene(const std::filesystem::path& input, Work&& work) {
  if (!is_scene_file(input)) return with_error_kind(ErrorKind::misuse, std::forward<Work>(work));
  try {
    return with_error_kind(ErrorKind::input, [&] { return with_error_prefix(input.string(), work); });
  } catch (const OptionError& error) {
    throw Error(ErrorKind::input, input.string() + ": " + error.what());
  }
}

/// Runs what loads the body: faults of a file are its own, those of a generated body are its scene's.
template <class Work>
auto reading_body(const std::filesystem::path& input, const deformation::SolidSpec& spec, Work&& work) {
  if (spec.generated) return reading_scene(input, std::forward<Work>(work));
  return with_error_kind(ErrorKind::input, std::forward<Work>(work));
}

}  // namespace isostretch::app

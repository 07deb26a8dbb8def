#pragma once

#include "common/embedded_scenes.hpp"
#include "common/exit_code.hpp"

#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/scene/scene_input.hpp>

#include <filesystem>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace isostretch::app {

using scene::is_scene_file;
using scene::read_scene_input;
using scene::scene_folder;

/// Lets the option take the name of an embedded scene: where there is no file of that name, NAME becomes
/// NAME.json, which is_scene_file() knows as a scene.
void take_scene_names(CLI::Option& option, const std::vector<EmbeddedScene>& embedded);

/// Declares --list-scenes, which prints every embedded scene with the first line of its comment, and ends.
void declare_scene_list(CLI::App& cli, const std::vector<EmbeddedScene>& embedded);

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

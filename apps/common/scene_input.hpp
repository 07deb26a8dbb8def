#pragma once

#include "common/embedded_scenes.hpp"
#include "common/exit_code.hpp"
#include "common/output_folder.hpp"

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

/// Returns an object with these keys: from the scene file; where there is none of that name, from the
/// embedded scene of that name; empty when the input is a mesh. Throws Error naming the file, and for a
/// name that is neither a file nor a scene.
Json scene_object(const std::filesystem::path& input, const std::vector<std::string>& keys,
                  const std::vector<EmbeddedScene>& embedded = {});

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
  return with_error_kind(ErrorKind::input, [&] { return with_error_prefix(input.string(), work); });
}

}  // namespace isostretch::app

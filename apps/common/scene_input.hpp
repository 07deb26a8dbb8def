#pragma once

#include "common/exit_code.hpp"
#include "common/output_folder.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace isostretch::app {

// The input of an app is a scene by its name; otherwise it is a mesh, and the command line says the rest.
inline bool is_scene_file(const std::filesystem::path& input) {
  return input.extension() == ".json";
}

// Where the files that a scene names are sought.
inline std::filesystem::path scene_folder(const std::filesystem::path& input) {
  return is_scene_file(input) ? input.parent_path() : std::filesystem::path();
}

// An object with these keys from the scene file, empty when the input is none. Throws Failure naming the
// file.
Json scene_object(const std::filesystem::path& input, const std::vector<std::string>& keys);

// What a scene says wrong is the fault of its file, or of the command line when there is no such file; what
// is wrong in a mesh is that of the mesh in any case.
template <class Work>
auto reading_scene(const std::filesystem::path& input, Work&& work) {
  if (!is_scene_file(input)) return failing_with(ExitCode::command_line, std::forward<Work>(work));
  return failing_with(ExitCode::input, [&] { return naming_file(input, work); });
}

}  // namespace isostretch::app

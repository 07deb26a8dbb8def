#pragma once

#include <isostretch/scene/value.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::scene {

/// A scene that is part of a program: the name of its file without .json, and all of its text.
struct EmbeddedScene {
  std::string_view name;  ///< Name of the scene.
  std::string_view text;  ///< Content of its file.
};

/// Returns whether the input of a program is a scene, by its name; otherwise it is a mesh, and the command
/// line says the rest.
bool is_scene_file(const std::filesystem::path& input);

/// Returns the folder where the files that a scene names are sought; the current one for a mesh.
std::filesystem::path scene_folder(const std::filesystem::path& input);

/// Returns the embedded scene that an input names, without a folder, with or without .json; null where there
/// is none.
const EmbeddedScene* embedded_scene(const std::filesystem::path& input,
                                    const std::vector<EmbeddedScene>& embedded);

/// Returns whether there is a file of that name. A folder does not count: results often have the name of
/// their scene.
bool is_file(const std::filesystem::path& path);

/// Returns the scene in a file; where there is none of that name, the embedded scene of that name; an empty
/// one of the present schema when the input is a mesh. Older scenes are brought up to the present schema with
/// a notice, and keys that are none of `used`, which this program has no use for, are left out with a
/// warning; both go to the log. Throws Error of the kind `input` naming the file, and for a name that is
/// neither a file nor a scene.
Value read_scene_input(const std::filesystem::path& input, const std::vector<std::string>& used,
                       const std::vector<EmbeddedScene>& embedded = {});

/// Returns a line for every embedded scene: its name, and the comment that its text begins with, which says
/// what it shows.
std::string scene_list(const std::vector<EmbeddedScene>& embedded);

}  // namespace isostretch::scene

#pragma once

#include <string_view>
#include <vector>

namespace isostretch::app {

/// A scene that is part of the program: the name of its file without .json, and all of its text.
struct EmbeddedScene {
  std::string_view name, text;
};

/// Returns the scenes of this app, by name. Defined in every app that calls isostretch_embed_scenes() in its
/// CMakeLists.txt, and in no other.
const std::vector<EmbeddedScene>& embedded_scenes();

}  // namespace isostretch::app

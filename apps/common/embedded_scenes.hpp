#pragma once

#include <isostretch/scene/scene_input.hpp>

#include <vector>

namespace isostretch::app {

using scene::EmbeddedScene;

/// Returns the scenes of this app, by name. Defined in every app that calls isostretch_embed_scenes() in its
/// CMakeLists.txt, and in no other.
const std::vector<EmbeddedScene>& embedded_scenes();

}  // namespace isostretch::app

#pragma once

#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/scene/node.hpp>

namespace isostretch::scene {

/// How handles hold that say neither "soft" nor "hard".
enum class Holding { hard, soft };

/// Reads "handles" and "frames" of a scene for a body of that dimension; `frames` is taken where the scene
/// gives none. Soft handles without a weight of their own have weight 1. Throws Error naming the key by its
/// path.
deformation::HandleScript read_handle_script(const Node& scene, int dim, Holding holding, int frames);

}  // namespace isostretch::scene

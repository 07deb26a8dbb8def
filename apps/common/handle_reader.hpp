#pragma once

#include "common/deformation_names.hpp"

#include "common/json_value.hpp"

#include <isostretch/deformation/handle_script.hpp>

namespace isostretch::app {

// How handles hold that do not say it: hard, with "soft": WEIGHT for others; or soft, with "hard": true.
enum class Holding { hard, soft };

// "handles" and "frames" of a scene, docs/apps/isostretch-deform.md has all; without "frames" as many as
// given. Handles that are soft by default get the weight 1. Throws Error naming the key by its path.
HandleScript read_handle_script(const JsonValue& scene, int dim, Holding holding, int frames);

}  // namespace isostretch::app

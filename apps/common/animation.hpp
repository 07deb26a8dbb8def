#pragma once

#include "common/output_folder.hpp"

#include <isostretch/figures/animation.hpp>

#include <string>

namespace isostretch::app {

/// Adds NAME.glb to the folder, the frames as morph targets. Returns what is to be told: which frames those
/// are, or why there is no file; empty where it holds all.
std::string add_glb(OutputFolder& folder, const figures::Animation& animation, const std::string& name);

}  // namespace isostretch::app

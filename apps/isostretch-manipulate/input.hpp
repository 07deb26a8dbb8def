#pragma once

#include "command_line.hpp"

#include <isostretch/scene/manipulation_scene.hpp>

namespace isostretch::app::manipulate {

using Scene = scene::ManipulationScene;

// What the command line and its scene say, read in this order. All throw Failure naming the file, or the
// option, at fault.
SolidModel read_body(const CommandLine& command_line, const scene::Value& scene);
SolidCheck check_solid(const CommandLine& command_line, const scene::Value& scene);
Scene read_scene(const CommandLine& command_line, const scene::Value& scene, const SolidModel& body);
HandleSet read_rig(const CommandLine& command_line, const Scene& scene, const SolidModel& body);
// The last frame of the range must be one of the scene's.
FrameRange read_range(const Options& options, const Scene& scene);

}  // namespace isostretch::app::manipulate

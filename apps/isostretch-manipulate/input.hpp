#pragma once

#include "command_line.hpp"
#include "common/body.hpp"
#include "common/body_check.hpp"
#include "common/rig.hpp"
#include "scene.hpp"

namespace isostretch::app::manipulate {

// What the command line and its scene say, read in this order. All throw Failure naming the file, or the
// option, at fault.
Body read_body(const CommandLine& command_line, const Json& scene);
BodyCheck check_body(const CommandLine& command_line, const Json& scene);
Scene read_scene(const CommandLine& command_line, const Json& scene, const Body& body);
Rig read_rig(const CommandLine& command_line, const Scene& scene, const Body& body);
// The last frame of the range must be one of the scene's.
FrameRange read_range(const Options& options, const Scene& scene);

}  // namespace isostretch::app::manipulate

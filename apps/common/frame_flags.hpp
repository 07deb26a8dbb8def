#pragma once

#include <string>

namespace CLI {
class App;
}

namespace isostretch::app {

/// --glb and --no-picture: what apps write of a sequence of frames.
struct FrameFlags {
  bool glb = false;
  bool no_picture = false;
};

/// Declares them; `animation` is the name of the file that --glb adds.
void declare_frames(CLI::App& cli, FrameFlags& flags, const std::string& animation);

}  // namespace isostretch::app

#include "common/frame_flags.hpp"

#include <CLI/CLI.hpp>

namespace isostretch::app {

void declare_frames(CLI::App& cli, FrameFlags& flags, const std::string& animation) {
  cli.add_flag("--glb", flags.glb,
               "Also write " + animation +
                   ", an animation for Blender and game engines: the frames are morph targets (shape keys)");
  cli.add_flag("--no-picture", flags.no_picture,
               "Draw no pictures and write no report.html, which saves time on large bodies");
}

}  // namespace isostretch::app

#include "common/frame_flags.hpp"

#include "common/validators.hpp"

#include <CLI/CLI.hpp>

namespace isostretch::app {

void declare_frames(CLI::App& cli, FrameFlags& flags, const std::string& animation) {
  cli.add_option("--format", flags.format,
                 "File format of the frames: " + listed(all_names(frame_format_names)))
      ->check(one_of(all_names(frame_format_names)))
      ->type_name("NAME")
      ->default_str("vtu");
  cli.add_flag("--glb", flags.glb,
               "Also write " + animation +
                   ", an animation for Blender and game engines: the frames are morph targets (shape keys)");
  cli.add_flag("--no-picture", flags.no_picture,
               "Draw no pictures and write no report.html, which saves time on large bodies");
}

}  // namespace isostretch::app

#pragma once

#include "common/deformation_names.hpp"

#include "common/exit_code.hpp"

#include <filesystem>
#include <string>

namespace isostretch::app {

/// What --preview shows before anything is solved: the handles of a body and where they go by `time`.
struct Preview {
  const HandleSet& handle_set;
  const SolidModel& body;
  double time = 1;
  int up = -1;  ///< axis that is up in the picture; -1: guessed
};

/// Returns a table with a row for every handle: its name, whether it is hard or soft, how many nodes it has,
/// their mean at rest and at the time, how far the node goes that goes farthest, and by how much it turns.
std::string preview_table(const Preview& preview);

/// Draws the body at rest, each handle in a colour of its own: the triangles all of whose vertices it has, a
/// dot at every vertex of it on the surface (200 at most, evenly spread; a ring where the body hides it), or
/// inside where it has none there, and arrows from some of these to where they go. Returns the bytes of a
/// PNG.
std::string draw_preview(const Preview& preview);

/// Writes the picture to preview.png in that folder and prints the table. Throws Error with
/// ExitCode::output.
ExitCode show_preview(const Preview& preview, const std::filesystem::path& out);

}  // namespace isostretch::app

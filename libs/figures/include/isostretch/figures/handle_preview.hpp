#pragma once

#include <isostretch/deformation/handle_set.hpp>

#include <string>

namespace isostretch::figures {

/// The handles of a body, and where they go by a time, to be looked at before anything is solved.
struct HandlePreview {
  const deformation::HandleSet& handle_set;  ///< Handles.
  const deformation::SolidModel& body;       ///< Body that they are part of.
  double time = 1;                           ///< Time of the targets.
  int up = -1;                               ///< Axis that is up in the picture; -1 guesses it.
};

/// Returns a table with a row for every handle: its name, whether it is hard or soft, how many nodes it has,
/// their mean at rest and at the time, how far the node goes that goes farthest, and by how much it turns.
std::string preview_table(const HandlePreview& preview);

/// Draws the body at rest, each handle in a colour of its own: the triangles all of whose vertices it has, a
/// dot at every vertex of it on the surface (200 at most, evenly spread; a ring where the body hides it), or
/// inside where it has none there, and arrows from some of these to where they go. Returns the bytes of a
/// PNG.
std::string draw_preview(const HandlePreview& preview);

}  // namespace isostretch::figures

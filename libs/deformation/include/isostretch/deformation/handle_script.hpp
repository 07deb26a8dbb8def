#pragma once

#include <isostretch/handles/motion.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// A part of a body that moves, and how it moves.
struct HandleSpec {
  std::string path = {};                          ///< Place in the scene for messages, such as "handles[0]".
  std::string name = {};                          ///< Name for users.
  handles::Selection select = {};                 ///< Nodes of the handle.
  std::vector<handles::Keyframe> keyframes = {};  ///< Transforms at times of the script.
  /// Centre of rotation and scaling; none is the mean of its nodes.
  std::optional<handles::Point> center = {};
  std::optional<double> soft = {};  ///< Weight of a soft handle; none holds it hard.
};

/// The handles of a sequence, and the frames at which they are looked at.
struct HandleScript {
  std::vector<HandleSpec> handles;  ///< The handles.
  /// Time of frame 0.
  double start = 0, end = 1;  ///< Time of the last frame.
  int frames = 10;            ///< Number of frames after the rest shape.

  /// Returns the time at which handles leave their rest shape where they begin elsewhere: between it and
  /// `start` they come from there.
  double rest_time() const { return start - (end - start); }
  /// Returns the time of a frame; frame 0 is the rest shape.
  double time(int frame) const { return frame == frames ? end : start + (end - start) * frame / frames; }
};

}  // namespace isostretch::deformation

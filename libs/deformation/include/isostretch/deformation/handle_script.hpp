#pragma once

#include <isostretch/handles/motion.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// A part of a body that moves, and how.
struct HandleSpec {
  std::string path = {};  ///< for messages, such as "handles[0]"
  std::string name = {};
  handles::Selection select = {};
  std::vector<handles::Keyframe> keyframes = {};  ///< times are those of the script
  std::optional<handles::Point> center = {};      ///< none: the mean of its nodes
  std::optional<double> soft = {};                ///< weight; none: held hard
};

/// What moves, and when: handles and the frames they are looked at.
struct HandleScript {
  std::vector<HandleSpec> handles;
  double start = 0, end = 1;  ///< times
  int frames = 10;

  /// Returns when handles leave their rest shape, where they begin elsewhere: between this time and `start`
  /// they come from there.
  double rest_time() const { return start - (end - start); }
  /// Returns the time of a frame, 0 being the rest shape.
  double time(int frame) const { return frame == frames ? end : start + (end - start) * frame / frames; }
};

}  // namespace isostretch::deformation

#pragma once

#include <isostretch/handles/motion.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

struct HandleSpec {
  std::string path;  // in the scene, for messages
  std::string name;
  handles::Selection select;
  std::vector<handles::Keyframe> keyframes;  // times are those of the scene
  std::optional<handles::Point> center;      // none: the mean of its nodes
  std::optional<double> soft;                // weight; none: held hard
};

// What moves, and when: the handles of a scene with its frames.
struct HandleScript {
  std::vector<HandleSpec> handles;
  double start = 0, end = 1;  // times
  int frames = 10;

  // Handles come from rest between this time and `start`.
  double rest_time() const { return start - (end - start); }
  // Of frame 0, the rest shape, to the last.
  double time(int frame) const { return frame == frames ? end : start + (end - start) * frame / frames; }
};

}  // namespace isostretch::deformation

#include "frames.hpp"

#include <isostretch/deformation/frame_file.hpp>

#include <utility>
#include <vector>

namespace isostretch::reports {

double sum_over(const Json& frames, const char* key) {
  double total = 0;
  for (const Json& frame : frames) total += frame.value(key, 0.0);
  return total;
}

int inverted_frames(const Json& frames) {
  return count_frames(frames, [](const Json& frame) { return frame["inverted"].get<int>() > 0; });
}

int unconverged_frames(const Json& frames) {
  return count_frames(frames, [](const Json& frame) { return !frame["converged"].get<bool>(); });
}

std::string animation_text(const Json& frames) {
  std::vector<std::pair<std::string, double>> files;
  for (const Json& frame : frames)
    files.emplace_back(frame["file"].get<std::string>(), frame["time"].get<double>());
  return deformation::pvd_text(files);
}

}  // namespace isostretch::reports

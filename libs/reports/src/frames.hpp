// What reports on sequences of frames have in common. `frames`: an array with an object a frame.
#pragma once

#include "json.hpp"

#include <algorithm>
#include <string>

namespace isostretch::reports {

// Of a number in all frames; 0 where a frame has none.
double sum_over(const Json& frames, const char* key);

template <class Counts>
int count_frames(const Json& frames, const Counts& counts) {
  return static_cast<int>(std::count_if(frames.begin(), frames.end(), counts));
}

int inverted_frames(const Json& frames);
int unconverged_frames(const Json& frames);

// deformation::pvd_text() of their "file" and "time".
std::string animation_text(const Json& frames);

}  // namespace isostretch::reports

#pragma once

#include "common/exit_code.hpp"
#include "common/output_folder.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

namespace isostretch::app {

// What apps that make a sequence of frames say of it. `frames`: an array with an object a frame.

// Of a number in all frames; 0 where a frame has none.
double sum_over(const Json& frames, const char* key);

template <class Counts>
int count_frames(const Json& frames, const Counts& counts) {
  return static_cast<int>(std::count_if(frames.begin(), frames.end(), counts));
}

// pvd_text() of their "file" and "time".
std::string animation_text(const Json& frames);

// Prints what was written and, in the last line, the verdict, as an error unless the code is success; returns
// the code.
ExitCode conclude(const std::string& verdict, ExitCode code, const OutputFolder& folder,
                  const std::filesystem::path& out, bool verbose);

}  // namespace isostretch::app

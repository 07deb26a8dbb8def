#pragma once

#include "common/deformation_names.hpp"

#include "common/output_folder.hpp"
#include "scene.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace isostretch::app::deform {

// What --restart goes on from: everything up to the last good frame.
struct State {
  int frame = 0;      // the last good one
  Json frames;        // of summary.json, 0 to that one
  std::string trace;  // trace.csv up to it
  Vector positions;   // of that frame
};

inline constexpr const char* state_file = "restart.json";

// As the content of that file, with the scene and the body it belongs to. Numbers read back to the bit.
std::string state_text(const State& state, const Scene& scene, const SolidModel& body);

// Throws Error naming the file when there is none, and what has changed when it belongs to another scene or
// body, or what is damaged.
State read_state(const std::filesystem::path& folder, const Scene& scene, const SolidModel& body);

}  // namespace isostretch::app::deform

#pragma once

#include "common/deformation_names.hpp"
#include "common/frame_flags.hpp"
#include "common/look_flags.hpp"
#include "common/option_flags.hpp"
#include "common/repair_flags.hpp"
#include "common/scene_input.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isostretch::app::manipulate {

// Frames to make, both included.
struct FrameRange {
  int first = 1, last = 1;
};

// What does not belong to the scene: it changes no result.
struct Options {
  std::filesystem::path out;
  std::optional<FrameRange> range;  // none: all
  double time_limit = 0;            // seconds; 0: none
  double memory_limit = 0;          // megabytes, of a rival's process; 0: none
  std::string compare;              // solvers, as on the command line; empty: none
  int repetitions = 1;              // of each of them
  bool picture = true;
  bool glb = false;
  LookFlags look;
  std::filesystem::path weights_cache;  // empty: none
};

// The names of solvers that can take the place of the library's.
std::vector<std::string> rival_names();

// The options of this app: declared to CLI11, then read with everything that CLI11 cannot check itself.
class CommandLine {
 public:
  void declare(CLI::App& cli);

  // Both throw Error: of kind misuse naming the option at fault, of kind input where it is a scene file.
  Options options() const;
  // The scene file, if there is one, with what the command line adds or replaces.
  scene::Value scene() const;

  MeshRepair repair() const;
  bool has_scene_file() const { return is_scene_file(input_); }
  const std::filesystem::path& input() const { return input_; }
  // Where the files of the scene are looked for.
  std::filesystem::path folder() const { return scene_folder(input_); }
  int refine() const { return refine_; }
  bool compares() const { return !compare_.empty(); }

 private:
  void declare_files(CLI::App& cli);
  void declare_problem(CLI::App& cli);
  void declare_rivals(CLI::App& cli);
  void declare_photo(CLI::App& cli);
  std::string path_from_here(const std::string& file) const;
  void add_mesh(scene::Value& scene) const;
  void add_handles(scene::Value& scene) const;

  std::filesystem::path input_;
  std::string out_, weights_cache_, compare_;
  std::optional<std::string> mesh_, frames_, photo_, photo_fit_, rival_;
  std::optional<int> photo_cells_;
  std::vector<std::string> handles_;
  OptionFlags option_flags_;
  RepairFlags repair_flags_;
  FrameFlags frame_flags_;
  LookFlags look_;
  int refine_ = 1, repetitions_ = 1;
  double time_limit_ = 0, memory_limit_ = 0;
};

}  // namespace isostretch::app::manipulate

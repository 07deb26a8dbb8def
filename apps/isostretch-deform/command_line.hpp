#pragma once

#include "common/deformation_names.hpp"

#include "common/energy_flags.hpp"
#include "common/frame_flags.hpp"
#include "common/look_flags.hpp"
#include "common/option_flags.hpp"
#include "common/repair_flags.hpp"
#include "common/scene_input.hpp"
#include "options.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isostretch::app::deform {

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

 private:
  void declare_files(CLI::App& cli);
  void declare_scene(CLI::App& cli);
  void add_handles(scene::Value& scene) const;

  std::filesystem::path input_;
  std::string out_;
  std::optional<double> young_, poisson_;
  std::vector<std::string> handles_;
  EnergyFlags energy_flags_;
  OptionFlags option_flags_;
  RepairFlags repair_flags_;
  FrameFlags frame_flags_;
  LookFlags look_;
  int stop_after_ = -1;
  bool restart_ = false;
};

}  // namespace isostretch::app::deform

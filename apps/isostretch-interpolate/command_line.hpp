#pragma once

#include "common/energy_flags.hpp"
#include "common/frame_flags.hpp"
#include "common/option_flags.hpp"
#include "common/repair_flags.hpp"
#include "options.hpp"

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace isostretch::app::interpolate {

// The options of this app: declared to CLI11, then read with everything that CLI11 cannot check itself.
class CommandLine {
 public:
  void declare(CLI::App& cli);

  // Throws Error naming the option, or the file and key of the scene, at fault.
  Options options() const;

  // The first mesh, or the scene.
  const std::filesystem::path& input() const { return first_; }

 private:
  void declare_files(CLI::App& cli);
  scene::Value scene() const;

  std::filesystem::path first_;
  std::string second_, out_;
  EnergyFlags energy_flags_;
  OptionFlags option_flags_;
  RepairFlags repair_flags_;
  FrameFlags frame_flags_;
  bool check_ = false;
};

}  // namespace isostretch::app::interpolate

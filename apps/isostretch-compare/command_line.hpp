#pragma once

#include "common/energy_flags.hpp"
#include "common/option_flags.hpp"
#include "options.hpp"
#include "single_run.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isostretch::app::compare {

// The options of this app: declared to CLI11, then read with everything that CLI11 cannot check itself.
class CommandLine {
 public:
  void declare(CLI::App& cli);

  // The scene file, or one made of the meshes and energies, with what the command line adds or replaces.
  // Throws Error: with ExitCode::command_line naming the option at fault, with ExitCode::input where it is
  // a scene file.
  scene::Value scene() const;
  // Of that scene.
  Options options(const scene::Value& scene) const;

  const std::filesystem::path& scene_file() const { return scene_file_; }
  bool is_single_run() const { return !run_.empty(); }
  SingleRun single_run() const;

 private:
  void declare_problems(CLI::App& cli);
  void declare_methods(CLI::App& cli);
  void declare_single_run(CLI::App& cli);
  void add_problems(scene::Value& scene) const;

  std::vector<std::string> meshes_;
  std::filesystem::path scene_file_;
  std::string out_, run_, from_;
  std::optional<std::string> methods_;
  EnergyFlags energy_flags_;
  OptionFlags option_flags_;
  bool no_picture_ = false;
};

}  // namespace isostretch::app::compare

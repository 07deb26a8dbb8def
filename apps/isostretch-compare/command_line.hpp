#pragma once

#include "common/output_folder.hpp"
#include "options.hpp"
#include "single_run.hpp"

#include <nlohmann/json.hpp>

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
  Json scene() const;
  // Of that scene.
  Options options(const Json& scene) const;

  const std::filesystem::path& scene_file() const { return scene_file_; }
  bool is_single_run() const { return !run_.empty(); }
  SingleRun single_run() const;

 private:
  void declare_problems(CLI::App& cli);
  void declare_methods(CLI::App& cli);
  void declare_single_run(CLI::App& cli);
  void add_problems(Json& scene) const;

  std::vector<std::string> meshes_, parameters_;
  std::filesystem::path scene_file_;
  std::string energies_ = "symmetric_dirichlet";
  std::string out_, run_, from_;
  std::optional<std::string> methods_;
  std::optional<double> gradient_tolerance_, time_limit_, memory_limit_;
  std::optional<int> max_iterations_, repetitions_;
  bool no_picture_ = false;
};

}  // namespace isostretch::app::compare

#pragma once

#include "common/frame_flags.hpp"
#include "common/repair_flags.hpp"
#include "common/solver_flags.hpp"
#include "options.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isostretch::app::interpolate {

// The options of this app: declared to CLI11, then read with everything that CLI11 cannot check itself.
class CommandLine {
 public:
  void declare(CLI::App& cli);

  // Throws Error naming the option at fault.
  Options options() const;

 private:
  void declare_files(CLI::App& cli);
  void declare_energy(CLI::App& cli);

  Options defaults_;
  std::string first_, second_, out_;
  std::string energy_ = defaults_.energy;
  std::string guess_ = name_of(guess_names, defaults_.guess);
  int frames_ = defaults_.frames;
  std::vector<std::string> parameters_;
  SolverFlags solver_flags_;
  RepairFlags repair_flags_;
  FrameFlags frame_flags_;
  bool check_ = false;
};

}  // namespace isostretch::app::interpolate

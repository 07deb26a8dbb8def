#pragma once

#include "common/repair_flags.hpp"
#include "common/solver_flags.hpp"
#include "options.hpp"

#include <isostretch/energies/any_energy.hpp>

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isostretch::app::parameterize {

// The options of this app: declared to CLI11, then read with everything that CLI11 cannot check itself.
class CommandLine {
 public:
  void declare(CLI::App& cli);

  // All of these throw Failure with ExitCode::command_line naming the option at fault.
  Options options() const;
  energies::AnyEnergy energy() const;

 private:
  void declare_energy(CLI::App& cli);
  void declare_pins(CLI::App& cli);
  void declare_cut(CLI::App& cli);
  void declare_layout(CLI::App& cli);
  void declare_solve(CLI::App& cli);
  void declare_files(CLI::App& cli);

  std::string model_, out_, energy_ = "symmetric_dirichlet", initial_ = "tutte";
  SolverFlags solver_flags_;
  std::vector<std::string> parameters_, pins_, soft_pins_, horizontal_, vertical_;
  std::string holes_ = "short", seams_ = "input", boundary_ = "free", corners_, pack_ = "auto",
              overlap_ = "auto", uv_units_ = "auto";
  int cut_tips_ = Options().cut_tips, max_cuts_ = Options().max_cuts;
  double max_distortion_ = 0, margin_ = Options().margin;
  std::string weld_;
  const CLI::Option* weld_option_ = nullptr;
  bool check_ = false, triangulate_ = false, repair_ = false, no_cut_ = false, no_picture_ = false,
       glb_ = false;
};

}  // namespace isostretch::app::parameterize

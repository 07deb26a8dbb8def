#pragma once

#include "common/deformation_names.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace isostretch::app {

/// --repair and --weld of apps that read bodies.
class RepairFlags {
 public:
  void declare(CLI::App& cli);
  /// What was asked for. Throws Error naming the option for a tolerance that is negative or not finite.
  MeshRepair repair() const;

 private:
  bool repair_ = false;
  std::string weld_;
  const CLI::Option* weld_option_ = nullptr;
};

/// Declares --weld, alone or as --weld=TOLERANCE, so that no file behind it is taken for the tolerance.
const CLI::Option* declare_weld(CLI::App& cli, std::string& tolerance);
/// The tolerance of --weld, none where it was not given. Throws Error for one that is negative or not finite.
std::optional<double> weld_tolerance(const CLI::Option* option, const std::string& tolerance);

}  // namespace isostretch::app

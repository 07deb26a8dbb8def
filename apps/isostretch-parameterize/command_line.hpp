#pragma once

#include "common/energy_flags.hpp"
#include "common/option_flags.hpp"
#include "common/repair_flags.hpp"
#include "options.hpp"

#include <isostretch/scene/pin_text.hpp>

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace isostretch::app::parameterize {

// The options of this app: declared to CLI11, then read with everything that CLI11 cannot check itself.
class CommandLine {
 public:
  void declare(CLI::App& cli);

  // Throws Error: of kind misuse naming the option at fault, of kind input where it is a scene file.
  Options options() const;

 private:
  void declare_files(CLI::App& cli);
  void declare_pins(CLI::App& cli);
  scene::Value scene() const;

  std::filesystem::path input_;
  std::string out_;
  EnergyFlags energy_flags_;
  OptionFlags option_flags_;
  scene::PinTexts pins_;
  std::string weld_;
  const CLI::Option* weld_option_ = nullptr;
  bool check_ = false, triangulate_ = false, repair_ = false, no_picture_ = false, glb_ = false;
};

}  // namespace isostretch::app::parameterize

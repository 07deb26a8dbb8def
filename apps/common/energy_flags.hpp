#pragma once

#include <isostretch/scene/value.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isostretch::app {

/// --energy, --param and --list-energies: which energy is minimised, the same in every app.
class EnergyFlags {
 public:
  /// Declares them; `help` says what the energy is for, `fallback` is the energy taken where none is given,
  /// and `list` what --list-energies prints, asked
  /// for then, since plug-ins add to it.
  void declare(CLI::App& cli, const std::string& help, const std::string& fallback,
               std::function<std::string()> list);

  /// Puts what was given into "energy" of a scene, and the energy taken otherwise where it has none. Throws
  /// Error naming the option for parameters that are none, and the input where its energy can take none.
  void add_to(scene::Value& scene, const std::filesystem::path& input) const;

  /// Returns the name that was given, or the one taken otherwise.
  const std::string& name() const { return name_ ? *name_ : fallback_; }
  /// Returns the texts of --param.
  const std::vector<std::string>& parameters() const { return parameters_; }

 private:
  std::optional<std::string> name_;
  std::string fallback_;
  std::function<std::string()> list_;
  std::vector<std::string> parameters_;
};

/// Returns a list of all energies, in space and in the plane, for --list-energies.
std::string energy_list();

}  // namespace isostretch::app

#include "common/energy_flags.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/scene/energy_choice.hpp>

#include <CLI/CLI.hpp>

#include <iostream>
#include <utility>

namespace isostretch::app {

void EnergyFlags::declare(CLI::App& cli, const std::string& help, const std::string& fallback,
                          std::function<std::string()> list) {
  fallback_ = fallback;
  list_ = std::move(list);
  cli.add_option("-e,--energy", name_, help + "; --list-energies shows all")
      ->type_name("NAME")
      ->default_str(fallback);
  cli.add_option("-p,--param", parameters_,
                 "Set parameters of the energy: name=value[,name=value...]; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  cli.add_flag_callback(
         "--list-energies",
         [this] {
           std::cout << list_() << std::flush;
           throw CLI::Success{};
         },
         "List the energies and their parameters, and exit")
      ->trigger_on_parse();
}

void EnergyFlags::add_to(scene::Value& scene, const std::filesystem::path& input) const {
  const auto parameters =
      with_error_kind(ErrorKind::misuse, [this] { return scene::parse_parameters(parameters_); });
  if (name_) scene["energy"] = *name_;
  if (!scene.has("energy")) scene["energy"] = fallback_;
  if (parameters.empty()) return;
  scene::Value& energy = scene["energy"];
  if (energy.is_text()) energy = scene::Value::object("name", energy);
  if (!energy.is_object() || (energy.has("parameters") && !energy["parameters"].is_object()))
    throw Error(ErrorKind::input, input.string() + ": energy: is nothing that --param could add to");
  for (const auto& [name, value] : parameters) energy["parameters"][name] = value;
}

std::string energy_list() {
  return "In space:\n" + scene::energy_table(3) + "\nIn the plane:\n" + listed(scene::energy_names_in(2)) +
         "\n";
}

}  // namespace isostretch::app

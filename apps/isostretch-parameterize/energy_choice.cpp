#include "energy_choice.hpp"

#include "common/numbers.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>

#include <algorithm>
#include <map>

namespace isostretch::app::parameterize {
namespace {

std::vector<std::string> names_in_2d() {
  std::vector<std::string> names;
  for (const std::string& name : energies::energy_names())
    if (energies::make_energy(name).supports(2)) names.push_back(name);
  return names;
}

std::string in_2d() {
  std::string text;
  for (const std::string& name : names_in_2d()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::map<std::string, double> parse_parameters(const std::vector<std::string>& texts) {
  std::map<std::string, double> parameters;
  for (const std::string& text : texts)
    for (const std::string& assignment : split(text, ',')) {
      const std::size_t equals = assignment.find('=');
      if (equals == 0 || equals == std::string::npos)
        throw Error("--param: '" + assignment + "' is not of the form name=value");
      const auto value = finite_number(assignment.substr(equals + 1));
      if (!value) throw Error("--param: '" + assignment.substr(equals + 1) + "' is not a finite number");
      if (!parameters.emplace(assignment.substr(0, equals), *value).second)
        throw Error("--param: '" + assignment.substr(0, equals) + "' is given twice");
    }
  return parameters;
}

}  // namespace

std::string energy_table() {
  std::string table;
  for (const std::string& name : names_in_2d()) {
    const energies::AnyEnergy energy = energies::make_energy(name);
    table +=
        name + (energy.has_barrier() ? "" : "  (finite under inversion: the result may have flips)") + "\n";
    for (const auto& parameter : energy.parameters())
      table +=
          "    " + parameter.name + "=" + exact_text(parameter.value) + "  " + parameter.description + "\n";
  }
  return table;
}

energies::AnyEnergy choose_energy(const std::string& name, const std::vector<std::string>& parameters) {
  const auto known = energies::energy_names();
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw Error("--energy: unknown energy '" + name + "'; in 2D there are " + in_2d());
  energies::AnyEnergy energy = energies::make_energy(name, parse_parameters(parameters));
  if (!energy.supports(2))
    throw Error("--energy: '" + name + "' does not exist in 2D; in 2D there are " + in_2d());
  return energy;
}

}  // namespace isostretch::app::parameterize

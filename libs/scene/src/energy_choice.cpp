#include <isostretch/scene/energy_choice.hpp>

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/numbers.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/energies/registry.hpp>
#include <isostretch/expressions/expression.hpp>

#include <algorithm>
#include <set>

namespace isostretch::scene {
namespace {

std::string those_there_are(int dim) {
  return "in " + std::to_string(dim) + "D there are " + listed(energy_names_in(dim));
}

}  // namespace

std::vector<std::string> energy_names_in(int dim) {
  std::vector<std::string> names;
  for (const std::string& name : energies::energy_names())
    if (energies::make_energy(name).supports(dim)) names.push_back(name);
  return names;
}

std::string energy_table(int dim) {
  std::string table;
  for (const std::string& name : energy_names_in(dim)) {
    const energies::AnyEnergy energy = energies::make_energy(name);
    table +=
        name + (energy.has_barrier() ? "" : "  (finite under inversion: the result may have flips)") + "\n";
    for (const auto& parameter : energy.parameters())
      table += "    " + parameter.name + "=" + to_text(parameter.value) + "  " + parameter.description + "\n";
  }
  return table;
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

namespace {

energies::AnyEnergy make_energy(const std::string& name, const std::map<std::string, double>& parameters,
                                int dim) {
  if (expressions::is_expression(name)) return expressions::parse_energy(name, parameters);
  const auto known = energies::energy_names();
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw Error("unknown energy '" + name + "'; " + those_there_are(dim));
  return energies::make_energy(name, parameters);
}

}  // namespace

energies::AnyEnergy choose_energy(const std::string& name, const std::map<std::string, double>& parameters,
                                  int dim) {
  energies::AnyEnergy energy = make_energy(name, parameters, dim);
  if (!energy.supports(dim))
    throw Error("'" + name + "' does not exist in " + std::to_string(dim) + "D; " + those_there_are(dim));
  return energy;
}

std::map<std::string, double> parameters_of(const std::string& energy,
                                            const std::map<std::string, double>& all) {
  std::set<std::string> names;
  if (expressions::is_expression(energy)) {
    names = expressions::parameter_names(energy);
  } else {
    const energies::AnyEnergy chosen = choose_energy(energy, {}, 2);
    for (const auto& parameter : chosen.parameters()) names.insert(parameter.name);
  }
  std::map<std::string, double> own;
  for (const auto& [name, value] : all)
    if (names.contains(name)) own.emplace(name, value);
  return own;
}

std::vector<std::string> split_energies(const std::string& text) {
  std::vector<std::string> all(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0)
      all.emplace_back();
    else
      all.back() += c;
  }
  return all;
}

}  // namespace isostretch::scene

#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>

#include <algorithm>
#include <cmath>

#include "builtin_includes.inc"

namespace isostretch::energies {
namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

template <class Energy>
AnyEnergy build(const std::map<std::string, double>& parameters) {
  Energy energy;
  std::vector<std::string> known;
  energy.parameters([&](const char* name, double& value, const char*) {
    known.emplace_back(name);
    const auto given = parameters.find(name);
    if (given == parameters.end()) return;
    if (!std::isfinite(given->second))
      throw Error("parameter '" + given->first + "' of energy '" + Energy::name + "' is not a finite number");
    value = given->second;
  });
  for (const auto& [name, value] : parameters)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(std::string("energy '") + Energy::name + "' has no parameter '" + name + "'; it has " +
                  (known.empty() ? "none" : join(known)));
  return AnyEnergy(energy);
}

struct Entry {
  const char* name;
  AnyEnergy (*build)(const std::map<std::string, double>&);
};

constexpr Entry entries[] = {
#define ISOSTRETCH_ENERGY(Struct) {Struct::name, build<Struct>},
#include "builtin_list.inc"
#undef ISOSTRETCH_ENERGY
};

}  // namespace

std::vector<std::string> energy_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  std::sort(names.begin(), names.end());
  return names;
}

AnyEnergy make_energy(std::string_view name, const std::map<std::string, double>& parameters) {
  for (const Entry& entry : entries)
    if (entry.name == name) return entry.build(parameters);
  throw Error("unknown energy '" + std::string(name) + "'; there are " + join(energy_names()));
}

}  // namespace isostretch::energies

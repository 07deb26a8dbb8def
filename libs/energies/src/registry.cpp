#include <isostretch/core/error.hpp>
#include <isostretch/energies/registry.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include "builtin_includes.inc"

namespace isostretch::energies {
namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<EnergyEntry>& registry() {
  static std::vector<EnergyEntry> all{
#define ISOSTRETCH_ENERGY(Struct) entry_of<Struct>(),
#include "builtin_list.inc"
#undef ISOSTRETCH_ENERGY
  };
  return all;
}

}  // namespace

void require_known_parameters(const char* energy, const std::vector<std::string>& known,
                              const std::map<std::string, double>& given) {
  for (const auto& [name, value] : given) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(std::string("energy '") + energy + "' has no parameter '" + name + "'; it has " +
                  (known.empty() ? "none" : join(known)));
    if (!std::isfinite(value))
      throw Error("parameter '" + name + "' of energy '" + energy + "' is not a finite number");
  }
}

void add_energy(EnergyEntry entry) {
  for (const EnergyEntry& other : registry())
    if (other.name == entry.name) throw Error("there is an energy '" + entry.name + "' already");
  registry().push_back(std::move(entry));
}

std::vector<std::string> energy_names() {
  std::vector<std::string> names;
  for (const EnergyEntry& entry : registry()) names.push_back(entry.name);
  std::sort(names.begin(), names.end());
  return names;
}

AnyEnergy make_energy(std::string_view name, const std::map<std::string, double>& parameters) {
  for (const EnergyEntry& entry : registry())
    if (entry.name == name) return entry.make(parameters);
  throw Error("unknown energy '" + std::string(name) + "'; there are " + join(energy_names()));
}

}  // namespace isostretch::energies

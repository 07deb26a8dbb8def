#pragma once

#include <isostretch/energies/any_energy.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::energies {

/// A named way to make an energy from parameters.
struct EnergyEntry {
  std::string name;  ///< The name in the registry.
  /// Makes the energy with its default parameters but for those given. Throws Error naming a parameter that
  /// does not exist, or whose value is not finite.
  AnyEnergy (*make)(const std::map<std::string, double>& parameters) = nullptr;
};

/// Returns the registry entry of an energy struct, as AnyEnergy takes it.
template <class Energy>
EnergyEntry entry_of();

/// Adds an energy of the caller's to the registry, for as long as the program runs. Throws Error when the
/// name is taken. Must not be called while other threads use the registry.
void add_energy(EnergyEntry entry);

/// Returns the names of all energies in alphabetical order.
std::vector<std::string> energy_names();

/// Returns the energy of that name with its default parameters but for those given. Throws Error, which names
/// what exists, for an unknown name or parameter, and for a value that is not finite.
AnyEnergy make_energy(std::string_view name, const std::map<std::string, double>& parameters = {});

/// Throws Error if `given` has a name that is not in `known`, or a value that is not finite.
void require_known_parameters(const char* energy, const std::vector<std::string>& known,
                              const std::map<std::string, double>& given);

// Compiled with the caller's flags, as the energy is.
inline namespace ISOSTRETCH_ISA {
namespace detail {

template <class Energy>
AnyEnergy make(const std::map<std::string, double>& parameters) {
  Energy energy;
  std::vector<std::string> known;
  if constexpr (requires { energy.parameters([](const char*, double&, const char*) {}); }) {
    energy.parameters([&](const char* name, double& value, const char*) {
      known.emplace_back(name);
      if (const auto given = parameters.find(name); given != parameters.end()) value = given->second;
    });
  }
  require_known_parameters(Energy::name, known, parameters);
  return AnyEnergy(energy);
}

}  // namespace detail
}  // namespace ISOSTRETCH_ISA

template <class Energy>
EnergyEntry entry_of() {
  return {Energy::name, detail::make<Energy>};
}

}  // namespace isostretch::energies

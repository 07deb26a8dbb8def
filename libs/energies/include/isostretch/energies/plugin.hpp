#pragma once

// Energies in a shared library of the user's, for every app (--plugin FILE):
//
//   #include <isostretch/energies/plugin.hpp>
//   struct MyEnergy { ... };                      // as isostretch/energies/evaluate.hpp has it
//   ISOSTRETCH_ENERGY_PLUGIN(MyEnergy)            // once in a library, with one struct or several
//
//   c++ -std=c++20 -O3 -march=native -fPIC -shared my_energy.cpp -o my_energy.so   (and the include paths)
//
// with the compiler and the version of isostretch that the app has: structures cross the boundary.

#include <isostretch/core/version.hpp>
#include <isostretch/energies/registry.hpp>

#include <string>
#include <vector>

namespace isostretch::energies {

/// The contents of an energy plug-in, a shared library with energies of the user's.
struct Plugin {
  const char* version;                    ///< The version of isostretch that the plug-in was compiled with.
  std::vector<EnergyEntry> (*entries)();  ///< Returns an entry for each energy of the plug-in.
};

/// The name of the one symbol that a plug-in exports, a Plugin.
inline constexpr const char* plugin_symbol = "isostretch_energy_plugin";

/// Returns the registry entries of several energy structs.
template <class... Energies>
std::vector<EnergyEntry> entries_of() {
  return {entry_of<Energies>()...};
}

/// Adds the energies of a plug-in to the registry; its library stays loaded. Throws Error naming the file
/// where that is none, or one of another version, or a name is taken.
void load_plugin(const std::string& file);

}  // namespace isostretch::energies

/// Defines the symbol of a plug-in with the given energy structs. It is written once in the shared library,
/// which must be compiled with the compiler and the version of isostretch that the app has: structures cross
/// the boundary.
#define ISOSTRETCH_ENERGY_PLUGIN(...)                                          \
  extern "C" const ::isostretch::energies::Plugin isostretch_energy_plugin;    \
  extern "C" const ::isostretch::energies::Plugin isostretch_energy_plugin = { \
      ::isostretch::version_string, ::isostretch::energies::entries_of<__VA_ARGS__>};

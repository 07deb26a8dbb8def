#include <isostretch/core/error.hpp>
#include <isostretch/energies/plugin.hpp>

#include <dlfcn.h>

#include <filesystem>
#include <string_view>

namespace isostretch::energies {

void load_plugin(const std::string& file) {
  // By its path: dlopen looks elsewhere for names without a slash.
  void* library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw Error(file + " cannot be loaded: " + dlerror());
  const auto* plugin = static_cast<const Plugin*>(dlsym(library, plugin_symbol));
  if (plugin == nullptr) throw Error(file + " is no plug-in of energies: it has no ISOSTRETCH_ENERGY_PLUGIN");
  if (std::string_view(plugin->version) != version_string)
    throw Error(file + " is for isostretch " + plugin->version + ", this is " + std::string(version_string));
  for (EnergyEntry& entry : plugin->entries()) {
    try {
      add_energy(std::move(entry));
    } catch (const Error& error) {
      throw Error(file + ": " + error.what());
    }
  }
}

}  // namespace isostretch::energies

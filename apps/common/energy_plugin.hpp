#pragma once

#include <string>

namespace isostretch::app {

// Adds the energies of a plug-in (isostretch/energies/plugin.hpp) to the registry; its library stays loaded.
// Throws Error naming the file where that is none, or one of another version, or a name is taken.
void load_energies(const std::string& file);

}  // namespace isostretch::app

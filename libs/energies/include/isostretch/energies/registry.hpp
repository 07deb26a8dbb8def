#pragma once

#include <isostretch/energies/any_energy.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::energies {

// Names of the built-in energies in alphabetical order.
std::vector<std::string> energy_names();

// The built-in energy of that name with its default parameters but for those given. An unknown name or
// parameter, and a value that is not finite, throw Error naming what there is.
AnyEnergy make_energy(std::string_view name, const std::map<std::string, double>& parameters = {});

}  // namespace isostretch::energies

#pragma once

#include <isostretch/energies/any_energy.hpp>

#include <string>
#include <vector>

namespace isostretch::app::parameterize {

// The energies that exist in 2D with their parameters and defaults, a line each.
std::string energy_table();

// `parameters` holds name=value, or several of them with commas between. Throws Error naming what there is
// when the energy, a parameter or a number is none, and when the energy does not exist in 2D.
energies::AnyEnergy choose_energy(const std::string& name, const std::vector<std::string>& parameters);

}  // namespace isostretch::app::parameterize

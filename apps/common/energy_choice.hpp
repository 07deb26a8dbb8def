#pragma once

#include <isostretch/energies/any_energy.hpp>

#include <map>
#include <string>
#include <vector>

namespace isostretch::app {

// The energies that exist in that dimension with their parameters and defaults, a line each.
std::string energy_table(int dim);
std::vector<std::string> energy_names_in(int dim);

// From texts that hold name=value, or several of them with commas between. Throws Error, beginning with
// --param, when one is none or a name is given twice.
std::map<std::string, double> parse_parameters(const std::vector<std::string>& texts);

// One of the names, or an expression (library expressions). Throws Error naming what there is when the energy
// or a parameter is none, and when the energy does not exist in that dimension.
energies::AnyEnergy choose_energy(const std::string& name, const std::map<std::string, double>& parameters,
                                  int dim);

// Those of the parameters that the energy, a name or an expression, has.
std::map<std::string, double> parameters_of(const std::string& energy,
                                            const std::map<std::string, double>& all);

// Names or expressions with commas between, which stand outside of parentheses.
std::vector<std::string> split_energies(const std::string& text);

}  // namespace isostretch::app

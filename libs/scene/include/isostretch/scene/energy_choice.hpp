#pragma once

#include <isostretch/energies/any_energy.hpp>

#include <map>
#include <string>
#include <vector>

namespace isostretch::scene {

/// Returns the energies that exist in that dimension, with their parameters and defaults, a line each.
std::string energy_table(int dim);
/// Returns the names of the energies that exist in that dimension.
std::vector<std::string> energy_names_in(int dim);

/// Returns the parameters in texts of the form name=value, or several of them with commas between. Throws
/// Error, beginning with --param, when one is none or a name is given twice.
std::map<std::string, double> parse_parameters(const std::vector<std::string>& texts);

/// Returns the energy of that name, or the one that an expression describes (library expressions). Throws
/// Error naming what there is when there is no such energy or parameter, and when the energy does not exist
/// in that dimension.
energies::AnyEnergy choose_energy(const std::string& name, const std::map<std::string, double>& parameters,
                                  int dim);

/// Returns those of the parameters that the energy, a name or an expression, has.
std::map<std::string, double> parameters_of(const std::string& energy,
                                            const std::map<std::string, double>& all);

/// Returns the names or expressions in a list with commas between; commas in parentheses separate nothing.
std::vector<std::string> split_energies(const std::string& text);

}  // namespace isostretch::scene

#pragma once

#include <map>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// Lame parameters of small strain.
struct Lame {
  double mu = 1;      ///< Shear modulus, in the units of stress.
  double lambda = 1;  ///< First Lame parameter, in the units of stress.
};

/// Returns the Lame parameters of Young's modulus and Poisson's ratio; in the plane they mean plane strain.
/// Throws Error unless young > 0 and -1 < poisson < 0.5.
Lame lame_from_young(double young, double poisson);

/// Throws Error unless shear and bulk modulus are positive.
void require_stable(const Lame& material, int dim);

/// Returns the parameters by which an energy has these Lame parameters at small strain. Throws Error, naming
/// the energies that have some, for an energy that has none.
std::map<std::string, double> material_parameters(const std::string& energy, const Lame& material, int dim);

/// Returns the names of the energies that can be given Lame parameters.
std::vector<std::string> energies_with_material();

}  // namespace isostretch::deformation

#pragma once

#include <map>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// Lame parameters of small strain.
struct Lame {
  double mu = 1;
  double lambda = 1;
};

/// In the plane it is plane strain. Throws Error unless young > 0 and -1 < poisson < 0.5.
Lame lame_from_young(double young, double poisson);

/// Throws Error unless shear and bulk modulus are positive.
void require_stable(const Lame& material, int dim);

/// The parameters by which that energy has these Lame parameters at small strain. Throws Error, naming those
/// that have some, for an energy that has none.
std::map<std::string, double> material_parameters(const std::string& energy, const Lame& material, int dim);

std::vector<std::string> energies_with_material();

}  // namespace isostretch::deformation

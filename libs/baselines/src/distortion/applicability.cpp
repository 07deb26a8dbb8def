#include "applicability.hpp"

#include <algorithm>

namespace isostretch::baselines {

std::string needs_dimension(const DistortionProblem& problem, int dim) {
  if (problem.elements.dim == dim) return "";
  return "it exists in " + std::to_string(dim) + "D only";
}

std::string needs_energy(const DistortionProblem& problem, std::initializer_list<std::string_view> energies) {
  if (std::find(energies.begin(), energies.end(), problem.energy.name()) != energies.end()) return "";
  std::string names;
  for (const std::string_view energy : energies) names += (names.empty() ? "" : ", ") + std::string(energy);
  return "it is for " + names + ", not for " + problem.energy.name();
}

std::string needs_barrier(const DistortionProblem& problem) {
  if (problem.energy.has_barrier()) return "";
  return "it needs an energy that keeps elements from inverting, which " + problem.energy.name() + " is not";
}

}  // namespace isostretch::baselines

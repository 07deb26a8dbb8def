#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/material.hpp>

#include <functional>
#include <utility>

namespace isostretch::deformation {
namespace {

using Parameters = std::map<std::string, double>;
using Mapping = std::function<Parameters(const Lame&, int dim)>;

Parameters as_they_are(const Lame& m, int) {
  return {{"mu", m.mu}, {"lambda", m.lambda}};
}

Parameters with_kappa(const Lame& m, int) {
  return {{"mu", m.mu}, {"kappa", m.lambda}};
}

Parameters with_mu_added(const Lame& m, int) {
  return {{"mu", m.mu}, {"lambda", m.lambda + m.mu}};
}

// Small strain of psi has mu d/(d+1) and lambda - mu (d/(d+1) - 2/(d+1)^2).
Parameters with_logarithm(const Lame& m, int dim) {
  const double n = dim + 1, mu = m.mu * n / dim;
  return {{"mu", mu}, {"lambda", m.lambda + mu * (dim / n - 2 / (n * n))}};
}

const std::vector<std::pair<std::string, Mapping>>& mappings() {
  static const std::vector<std::pair<std::string, Mapping>> table{{"corotational", with_kappa},
                                                                  {"fixed_corotational", as_they_are},
                                                                  {"hencky", as_they_are},
                                                                  {"neo_hookean_log", as_they_are},
                                                                  {"st_venant_kirchhoff", with_kappa},
                                                                  {"stable_neo_hookean", with_mu_added},
                                                                  {"stable_neo_hookean_log", with_logarithm}};
  return table;
}

}  // namespace

Lame lame_from_young(double young, double poisson) {
  if (!(young > 0)) throw Error(formatted("young is %g, must be positive", young));
  if (!(poisson > -1 && poisson < 0.5))
    throw Error(formatted("poisson is %g, must be above -1 and below 0.5", poisson));
  return {young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))};
}

void require_stable(const Lame& m, int dim) {
  if (!(m.mu > 0)) throw Error(formatted("mu is %g, must be positive", m.mu));
  if (!(m.lambda > -2 * m.mu / dim))
    throw Error(formatted("lambda is %g, must be above -2/%d mu", m.lambda, dim));
}

std::map<std::string, double> material_parameters(const std::string& energy, const Lame& material, int dim) {
  require_stable(material, dim);
  for (const auto& [name, mapping] : mappings())
    if (name == energy) return mapping(material, dim);
  throw Error("energy '" + energy + "' has no Lame parameters; those that have are " +
              listed(energies_with_material()));
}

std::vector<std::string> energies_with_material() {
  std::vector<std::string> names;
  for (const auto& entry : mappings()) names.push_back(entry.first);
  return names;
}

}  // namespace isostretch::deformation

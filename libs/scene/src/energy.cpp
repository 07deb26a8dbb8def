#include <isostretch/scene/energy.hpp>

#include "definitions.hpp"

#include <isostretch/deformation/material.hpp>
#include <isostretch/expressions/expression.hpp>
#include <isostretch/scene/energy_choice.hpp>

#include <map>

namespace isostretch::scene {
namespace {

using deformation::Lame;

Lame read_material(const Node& value, int dim) {
  value.only(keys_of("material"));
  const bool engineer = value.has("young") || value.has("poisson");
  if (engineer == (value.has("mu") || value.has("lambda")))
    value.fail("give young and poisson, or mu and lambda");
  const Lame material = engineer ? naming(value,
                                          [&] {
                                            return deformation::lame_from_young(value.at("young").number(),
                                                                                value.at("poisson").number());
                                          })
                                 : Lame{value.at("mu").number(), value.at("lambda").number()};
  naming(value, [&] { deformation::require_stable(material, dim); });
  return material;
}

std::map<std::string, double> read_parameters(const std::optional<Node>& value) {
  std::map<std::string, double> parameters;
  if (!value) return parameters;
  if (!value->value().is_object()) value->fail("must be an object {...}");
  for (const Member& member : value->value().members())
    parameters[member.key] = value->at(member.key).number();
  return parameters;
}

}  // namespace

energies::AnyEnergy read_energy(const Node& owner, int dim, const std::optional<Node>& fallback) {
  auto energy = owner.find("energy");
  if (!energy && fallback) energy = fallback->find("energy");
  if (!energy) owner.fail("'energy' is missing");
  if (!energy->value().is_text()) energy->only(keys_of("energy"));
  const Node name = energy->value().is_text() ? *energy : energy->at("name");
  auto parameters = read_parameters(energy->find("parameters"));
  auto material = owner.find("material");
  if (!material && fallback && !owner.has("energy")) material = fallback->find("material");
  if (!expressions::is_expression(name.text()))
    naming(name, [&] { return choose_energy(name.text(), {}, dim); });
  if (material) {
    const Lame lame = read_material(*material, dim);
    const auto from_material =
        naming(*material, [&] { return deformation::material_parameters(name.text(), lame, dim); });
    for (const auto& [key, number] : from_material)
      if (!parameters.emplace(key, number).second)
        material->fail("sets the parameter '" + key + "', which the energy sets too");
  }
  return naming(*energy, [&] { return choose_energy(name.text(), parameters, dim); });
}

}  // namespace isostretch::scene

#include "body_problem.hpp"
#include "json.hpp"
#include "surface_problem.hpp"

#include <isostretch/assembly/energy_assembler.hpp>
#include <isostretch/comparison/method_scene.hpp>
#include <isostretch/comparison/problem.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/fingerprint.hpp>
#include <isostretch/deformation/strain.hpp>

#include <cmath>
#include <utility>

namespace isostretch::comparison {

using deformation::Strain;

namespace {

double energy_at_start(const Problem& problem) {
  assembly::EnergyAssembler assembler(problem.distortion.elements, problem.distortion.energy);
  return assembler.value(problem.start.data()).value;
}

void require_finite_start(const Problem& problem) {
  if (std::isfinite(energy_at_start(problem))) return;
  const deformation::StrainField strain = Strain(problem.distortion.elements).at(problem.start);
  throw Error(ErrorKind::input,
              "problem '" + problem.name + "': the energy '" + problem.distortion.energy.name() +
                  "' is not finite at the start, where element " + std::to_string(strain.worst_element()) +
                  formatted(" has det F = %.3g; move the handles less far, or choose another guess",
                            strain.smallest_det()));
}

// By which results of another problem of the same name are known.
std::string fingerprint(const Problem& problem) {
  const assembly::Elements& elements = problem.distortion.elements;
  deformation::Fingerprint print;
  print.add(elements.nodes);
  print.add(elements.gradients);
  print.add(elements.weights);
  print.add(problem.distortion.pinned);
  print.add(problem.start);
  return print.text();
}

void add_facts(Problem& problem) {
  const assembly::Elements& elements = problem.distortion.elements;
  Json parameters = Json::object();
  for (const auto& parameter : problem.distortion.energy.parameters())
    parameters[parameter.name] = parameter.value;
  Json facts = json_of(problem.facts);
  facts.update({{"dim", elements.dim},
                {"elements", elements.element_count()},
                {"nodes", elements.node_count},
                {"pinned", problem.distortion.pinned.size()},
                {"energy", problem.distortion.energy.name()},
                {"parameters", parameters},
                {"start_energy", energy_at_start(problem)},
                {"fingerprint", fingerprint(problem)}});
  problem.facts = record_of(std::move(facts));
}

}  // namespace

int Problem::flips(const Vector& x) const {
  return static_cast<int>(Strain(distortion.elements).at(x).inverted.size());
}

Problem read_problem(const scene::Node& value, const std::filesystem::path& folder,
                     const ProblemWarning& warn) {
  Problem problem = value.has("handles") ? body_problem(value, folder, warn) : surface_problem(value, folder);
  problem.name = problem_name(value);
  require_finite_start(problem);
  add_facts(problem);
  return problem;
}

}  // namespace isostretch::comparison

#include "body_problem.hpp"

#include "json.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/deformation/predictor.hpp>
#include <isostretch/scene/energy.hpp>
#include <isostretch/scene/handles.hpp>
#include <isostretch/scene/solid.hpp>

#include <cmath>

namespace isostretch::comparison {

using deformation::HandleScript;
using deformation::HandleSet;
using deformation::HandleSpec;
using deformation::InitialGuess;
using deformation::SolidModel;
using deformation::SolidSpec;

namespace {

SolidModel read_body(const scene::Node& value, const std::filesystem::path& folder) {
  SolidSpec spec = scene::read_solid(value, folder);
  spec.repair.offered = false;
  const auto load = [&] { return deformation::load_solid(spec); };
  return spec.generated ? naming(value.at("mesh"), load) : with_error_kind(ErrorKind::input, load);
}

HandleScript read_script(const scene::Node& value, int dim) {
  HandleScript script = scene::read_handle_script(value, dim, scene::Holding::hard, 1);
  for (const HandleSpec& handle : script.handles)
    if (handle.soft)
      throw Error(handle.path + ".soft: only hard handles are compared, which all methods know");
  return script;
}

// Where handles hold, and nodes of no element, which nothing moves.
std::vector<int> pinned_nodes(const HandleSet& handle_set, const SolidModel& body) {
  std::vector<int> pinned = handle_set.hard_nodes();
  const std::vector<int> component = assembly::component_of_nodes(body.elements);
  for (std::size_t node = 0; node < component.size(); ++node)
    if (component[node] < 0) pinned.push_back(static_cast<int>(node));
  return pinned;
}

Vector guessed_start(InitialGuess guess, const HandleScript& script, const SolidModel& body,
                     const HandleSet& handle_set, const ProblemWarning& warn) {
  const double from = handle_set.comes_from_rest() ? script.rest_time() : script.start;
  return deformation::Predictor(guess, body, handle_set, warn)
      .guess(body.rest_positions(), from, script.end, false);
}

// Lengths are multiplied so that the rest has volume 1, and gradients are comparable among bodies.
void scale_to_unit_volume(double volume, assembly::Elements& elements, Vector& positions) {
  const double factor = std::pow(volume, -1.0 / elements.dim);
  for (double& weight : elements.weights) weight /= volume;
  for (double& gradient : elements.gradients) gradient /= factor;
  positions *= factor;
}

}  // namespace

Problem body_problem(const scene::Node& value, const std::filesystem::path& folder,
                     const ProblemWarning& warn) {
  value.only({"name", "mesh", "energy", "material", "handles", "initial_guess", "order", "quadrature"});
  const SolidModel body = read_body(value, folder);
  const energies::AnyEnergy energy = scene::read_energy(value, body.dim);
  const HandleScript script = read_script(value, body.dim);
  const HandleSet handle_set(script, body);
  const auto guess = value.find("initial_guess");
  const InitialGuess kind =
      guess ? guess->choice(deformation::choice_names(InitialGuess{})) : InitialGuess::biharmonic;
  Problem problem{{},
                  {body.elements, energy, pinned_nodes(handle_set, body)},
                  guessed_start(kind, script, body, handle_set, warn),
                  record_of({{"kind", deformation::plural_name(body.shape)},
                             {"mesh", body.name},
                             {"initial_guess", name_of(choice_names(kind), kind)}})};
  scale_to_unit_volume(body.volume(), problem.distortion.elements, problem.start);
  return problem;
}

}  // namespace isostretch::comparison

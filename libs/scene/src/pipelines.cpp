#include <isostretch/scene/pipelines.hpp>

#include "definitions.hpp"

#include <isostretch/scene/energy.hpp>
#include <isostretch/scene/handles.hpp>
#include <isostretch/scene/option_values.hpp>
#include <isostretch/scene/selection.hpp>

#include <cmath>
#include <limits>
#include <set>

namespace isostretch::scene {
namespace {

constexpr int most = std::numeric_limits<int>::max();
constexpr int most_frames = 1'000'000;

std::vector<OptionField> without(const std::string& name, std::vector<OptionField> fields) {
  std::erase_if(fields, [&](const OptionField& one) { return one.field.name == name; });
  return fields;
}

deformation::RegionSpec read_region(const Node& value, int dim, const Node& scene) {
  value.only(keys_of("region"));
  if (value.has("select") == value.has("elements")) value.fail("give either select or elements");
  if (!value.has("energy") && !value.has("material")) value.fail("gives neither energy nor material");
  deformation::RegionSpec region{value.path(), value.path(), {}, {}, read_energy(value, dim, scene)};
  if (const auto name = value.find("name")) region.name = name->text();
  if (const auto select = value.find("select")) region.select = read_selection(*select, dim);
  if (const auto elements = value.find("elements")) region.elements = elements->whole_numbers();
  return region;
}

// What no single key of "manipulation" says wrong.
void check_manipulation(const Node& group, const deformation::ManipulationOptions& options) {
  const auto& solver = options.solver;
  if (std::isfinite(options.largest_stretch) && solver.method != sdp_penalty::Method::interior_point)
    group.at("largest_stretch").fail("is known to the method interior_point alone");
  if (options.relinearize > 0 && solver.method == sdp_penalty::Method::unconstrained)
    group.at("relinearize").fail("needs a method that minimises with the constraint");
  if (const auto penalty = group.find("penalty"); penalty && solver.method != sdp_penalty::Method::penalty)
    penalty->fail("is of the method penalty alone");
  naming(group, [&] { solver.validate(); });
}

void read_pin(const Node& value, parameterization::Options& options, std::set<int>& pinned) {
  value.only(keys_of("pin"));
  const int vertex = value.at("vertex").whole(0, most);
  std::optional<parameterization::Point2> target;
  if (const auto at = value.find("target")) target = at->point(2).head<2>();
  if (const auto soft = value.find("soft")) {
    if (!target) value.fail("a soft pin needs a target");
    options.soft_pins.push_back({vertex, *target, soft->positive()});
    return;
  }
  if (!pinned.insert(vertex).second) value.fail("the vertex is pinned twice");
  options.pins.push_back({vertex, target});
}

void read_pins(const Node& group, parameterization::Options& options) {
  std::set<int> pinned;
  if (const auto pins = group.find("pins"))
    for (const Node& pin : pins->items()) read_pin(pin, options, pinned);
  if (const auto lines = group.find("aligned"))
    for (const Node& line : lines->items()) {
      line.only(keys_of("aligned"));
      line.at("line").require_one_of({"horizontal", "vertical"});
      options.aligned.push_back(
          {line.at("vertices").whole_numbers(), line.at("line").text() == "horizontal"});
    }
  if (const auto corners = group.find("corners")) options.corners = corners->whole_numbers();
}

}  // namespace

void read_newton(const Node& scene, newton::Options& options) {
  const auto value = scene.find("newton");
  if (!value) return;
  read_options(*value, options);
  if (options.gradient_tolerance > 0) {
    if (!value->has("scaled_gradient_tolerance")) options.scaled_gradient_tolerance = 0;
    if (!value->has("relative_energy_tolerance")) options.relative_energy_tolerance = 0;
  }
  naming(*value, [&] { options.validate(); });
}

deformation::SequenceOptions read_sequence(const Node& scene, int dim) {
  deformation::SequenceOptions options{.energy = read_energy(scene, dim)};
  if (const auto regions = scene.find("regions"))
    for (const Node& value : regions->items()) options.regions.push_back(read_region(value, dim, scene));
  options.script = read_handle_script(scene, dim, Holding::hard, options.script.frames);
  if (const auto guess = scene.find("initial_guess"))
    options.guess = guess->choice(choice_names(deformation::InitialGuess{}));
  read_newton(scene, options.newton);
  return options;
}

deformation::ManipulationOptions read_manipulation(const Node& scene, int dim) {
  deformation::ManipulationOptions options;
  options.script = read_handle_script(scene, dim, Holding::soft, 1);
  options.blend = handles::default_blend(dim);
  // Frames must not depend on those before.
  options.solver.augmented_lagrangian.warm_start = false;
  if (const auto group = scene.find("manipulation")) {
    read_options(*group, options);
    check_manipulation(*group, options);
  }
  return options;
}

std::vector<OptionField> interpolation_fields(deformation::InterpolationOptions& options) {
  return without("frames", without("newton", option_fields(options)));
}

std::vector<OptionField> parameterization_fields(parameterization::Options& options) {
  return without("newton", option_fields(options));
}

deformation::InterpolationOptions read_interpolation(const Node& scene) {
  deformation::InterpolationOptions options;
  if (const auto frames = scene.find("frames")) options.frames = frames->whole(1, most_frames);
  if (const auto group = scene.find("interpolation")) read_options(*group, interpolation_fields(options));
  read_newton(scene, options.newton);
  return options;
}

parameterization::Options read_parameterization(const Node& scene) {
  parameterization::Options options;
  if (const auto group = scene.find("parameterization")) {
    read_options(*group, parameterization_fields(options), {"pins", "aligned", "corners"});
    read_pins(*group, options);
  }
  read_newton(scene, options.newton);
  options.validate();
  return options;
}

}  // namespace isostretch::scene

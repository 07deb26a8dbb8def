#include "scene_reader.hpp"

#include "common/body_reader.hpp"
#include "common/energy_reader.hpp"
#include "common/handle_reader.hpp"
#include "common/json_value.hpp"
#include "common/selection_reader.hpp"
#include "common/solver_flags.hpp"

#include <isostretch/core/error.hpp>

namespace isostretch::app::deform {
namespace {

deformation::RegionSpec read_region(const JsonValue& value, int dim, const JsonValue& scene) {
  value.only({"name", "select", "elements", "energy", "material"});
  if (value.has("select") == value.has("elements")) value.fail("give either select or elements");
  if (!value.has("energy") && !value.has("material")) value.fail("gives neither energy nor material");
  deformation::RegionSpec region{value.path(), value.path(), {}, {}, read_energy(value, dim, scene)};
  if (const auto name = value.find("name")) region.name = name->text();
  if (const auto select = value.find("select")) region.select = read_selection(*select, dim);
  if (const auto elements = value.find("elements")) region.elements = elements->whole_numbers();
  return region;
}

}  // namespace

std::vector<std::string> scene_keys() {
  return {"mesh",    "order",  "quadrature", "energy", "material", "regions",
          "handles", "frames", "guess",      "format", "solver"};
}

SolidSpec read_body_spec(const Json& json, const std::filesystem::path& folder) {
  const JsonValue scene(json);
  scene.only(scene_keys());
  SolidSpec spec;
  read_mesh(scene.at("mesh"), folder, spec);
  if (const auto order = scene.find("order")) spec.order = order->whole(1, 2);
  if (const auto quadrature = scene.find("quadrature")) spec.quadrature = quadrature->whole(1, 5);
  return spec;
}

newton::Options read_solver(const Json& json) {
  newton::Options options;
  const auto value = JsonValue(json).find("solver");
  if (!value) return options;
  value->only({"projection", "gradient_tolerance", "max_iterations", "max_expansion", "backend", "ordering",
               "preconditioner", "largest_forcing"});
  if (const auto projection = value->find("projection")) {
    projection->require_one_of(newton::projection_names());
    options.projection = newton::projection_from_name(projection->text());
  }
  if (const auto tolerance = value->find("gradient_tolerance"))
    set_gradient_tolerance(options, tolerance->positive());
  if (const auto count = value->find("max_iterations"))
    options.max_iterations = count->whole(0, 1'000'000'000);
  if (const auto expansion = value->find("max_expansion")) options.max_expansion = expansion->number();
  if (const auto backend = value->find("backend"))
    options.solver.backend = naming(*backend, [&] { return sparse::backend_from_name(backend->text()); });
  if (const auto ordering = value->find("ordering"))
    options.solver.ordering = naming(*ordering, [&] { return sparse::ordering_from_name(ordering->text()); });
  if (const auto preconditioner = value->find("preconditioner"))
    options.solver.pcg_preconditioner =
        naming(*preconditioner, [&] { return sparse::preconditioner_from_name(preconditioner->text()); });
  if (const auto forcing = value->find("largest_forcing")) options.largest_forcing = forcing->number();
  naming(*value, [&] { options.validate(); });
  return options;
}

Json solver_json(const newton::Options& options) {
  Json json{{"projection", newton::projection_name(options.projection)},
            {"max_iterations", options.max_iterations},
            {"max_expansion", options.max_expansion},
            {"backend", sparse::backend_name(options.solver.backend)},
            {"ordering", sparse::ordering_name(options.solver.ordering)},
            {"preconditioner", sparse::preconditioner_name(options.solver.pcg_preconditioner)},
            {"largest_forcing", options.largest_forcing}};
  if (options.gradient_tolerance > 0) json["gradient_tolerance"] = options.gradient_tolerance;
  return json;
}

Scene read_scene(const Json& json, int dim) {
  const JsonValue scene(json);
  Scene result{{.energy = read_energy(scene, dim, {})}, json};
  if (const auto regions = scene.find("regions"))
    for (const JsonValue& value : regions->items()) result.regions.push_back(read_region(value, dim, scene));
  result.script = read_handle_script(scene, dim, Holding::hard, result.script.frames);
  if (const auto guess = scene.find("guess")) result.guess = guess->choice(deformation::initial_guess_names);
  if (const auto format = scene.find("format")) result.format = format->choice(frame_format_names);
  result.newton = read_solver(json);
  return result;
}

}  // namespace isostretch::app::deform

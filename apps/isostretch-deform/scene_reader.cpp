#include "scene_reader.hpp"

#include "common/energy_choice.hpp"
#include "common/json_value.hpp"
#include "common/solver_flags.hpp"
#include "material.hpp"
#include "selection_reader.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace isostretch::app::deform {
namespace {

constexpr int most = std::numeric_limits<int>::max();

// Errors of libraries that know no path get it here.
template <class Work>
auto naming(const JsonValue& value, Work&& work) {
  try {
    return work();
  } catch (const Error& error) {
    value.fail(error.what());
  }
}

// ---- body ----

BarSpec read_bar(const JsonValue& value) {
  value.only({"cells", "size", "element"});
  BarSpec bar;
  for (const JsonValue& item : value.at("cells").items()) bar.cells.push_back(item.whole(1, most));
  if (bar.cells.size() != 2 && bar.cells.size() != 3)
    value.at("cells").fail("must be 2 or 3 numbers, not " + std::to_string(bar.cells.size()));
  bar.size.assign(bar.cells.size(), 1.0);
  if (const auto size = value.find("size")) {
    const auto items = size->items();
    if (items.size() != bar.cells.size())
      size->fail("must be as many numbers as cells, " + std::to_string(bar.cells.size()));
    for (std::size_t i = 0; i < items.size(); ++i) bar.size[i] = items[i].positive();
  }
  bar.shape = bar.cells.size() == 2 ? mesh::Shape::triangle : mesh::Shape::tet;
  if (const auto element = value.find("element")) {
    element->require_one_of(shape_names());
    bar.shape = shape_from_name(element->text());
    if (mesh::shape_dim(bar.shape) != static_cast<int>(bar.cells.size()))
      element->fail("'" + element->text() + "' is " + std::to_string(mesh::shape_dim(bar.shape)) +
                    "D, and there are cells in " + std::to_string(bar.cells.size()) + " directions");
  }
  return bar;
}

// ---- energies ----

Lame read_material(const JsonValue& value, int dim) {
  value.only({"young", "poisson", "mu", "lambda"});
  const bool engineer = value.has("young") || value.has("poisson");
  if (engineer == (value.has("mu") || value.has("lambda")))
    value.fail("give young and poisson, or mu and lambda");
  const Lame material =
      engineer
          ? naming(value,
                   [&] { return lame_from_young(value.at("young").number(), value.at("poisson").number()); })
          : Lame{value.at("mu").number(), value.at("lambda").number()};
  naming(value, [&] { require_stable(material, dim); });
  return material;
}

std::map<std::string, double> read_parameters(const std::optional<JsonValue>& value) {
  std::map<std::string, double> parameters;
  if (!value) return parameters;
  if (!value->is_object()) value->fail("must be an object {...}");
  for (const auto& [name, number] : value->json().items()) parameters[name] = value->at(name).number();
  return parameters;
}

// "energy" and "material" of the scene or of a region, which has those of the scene where it gives none.
energies::AnyEnergy read_energy(const JsonValue& owner, int dim, const std::optional<JsonValue>& fallback) {
  auto energy = owner.find("energy");
  if (!energy && fallback) energy = fallback->find("energy");
  if (!energy) owner.fail("'energy' is missing");
  if (!energy->is_text()) energy->only({"name", "parameters"});
  const JsonValue name = energy->is_text() ? *energy : energy->at("name");
  auto parameters = read_parameters(energy->find("parameters"));
  auto material = owner.find("material");
  if (!material && fallback && !owner.has("energy")) material = fallback->find("material");
  naming(name, [&] { return choose_energy(name.text(), {}, dim); });
  if (material) {
    const Lame lame = read_material(*material, dim);
    const auto from_material = naming(*material, [&] { return material_parameters(name.text(), lame, dim); });
    for (const auto& [key, number] : from_material)
      if (!parameters.emplace(key, number).second)
        material->fail("sets the parameter '" + key + "', which the energy sets too");
  }
  return naming(*energy, [&] { return choose_energy(name.text(), parameters, dim); });
}

RegionSpec read_region(const JsonValue& value, int dim, const JsonValue& scene) {
  value.only({"name", "select", "elements", "energy", "material"});
  if (value.has("select") == value.has("elements")) value.fail("give either select or elements");
  if (!value.has("energy") && !value.has("material")) value.fail("gives neither energy nor material");
  RegionSpec region{value.path(), value.path(), {}, {}, read_energy(value, dim, scene)};
  if (const auto name = value.find("name")) region.name = name->text();
  if (const auto select = value.find("select")) region.select = read_selection(*select, dim);
  if (const auto elements = value.find("elements")) region.elements = elements->whole_numbers();
  return region;
}

// ---- handles ----

void read_rotation(const JsonValue& value, int dim, handles::Transform& transform) {
  value.only({"axis", "degrees"});
  transform.degrees = value.at("degrees").number();
  if (dim == 2) {
    if (const auto axis = value.find("axis")) axis->fail("in the plane there is one axis; leave it out");
    return;
  }
  transform.axis = value.at("axis").point(3);
  if (transform.axis.isZero(0)) value.at("axis").fail("has length zero");
}

handles::Transform read_transform(const JsonValue& value, int dim) {
  handles::Transform transform;
  if (const auto translate = value.find("translate")) transform.translation = translate->point(dim);
  if (const auto rotate = value.find("rotate")) read_rotation(*rotate, dim, transform);
  if (const auto scale = value.find("scale")) transform.scale = scale->positive();
  return transform;
}

std::vector<handles::Keyframe> read_keyframes(const JsonValue& value, int dim) {
  std::vector<handles::Keyframe> keys;
  for (const JsonValue& item : value.items()) {
    item.only({"time", "translate", "rotate", "scale"});
    keys.push_back({item.at("time").number(), read_transform(item, dim)});
    if (keys.size() > 1 && !(keys[keys.size() - 2].time < keys.back().time))
      item.at("time").fail("must be later than that of the keyframe before");
  }
  if (keys.empty()) value.fail("there must be one at least");
  return keys;
}

// A single key at time 1 stands for "from rest to there over the whole time", until the time is known.
HandleSpec read_handle(const JsonValue& value, int dim) {
  value.only({"name", "select", "translate", "rotate", "scale", "center", "keyframes", "soft"});
  HandleSpec handle;
  handle.path = handle.name = value.path();
  if (const auto name = value.find("name")) handle.name = name->text();
  handle.select = read_selection(value.at("select"), dim);
  if (const auto center = value.find("center")) handle.center = center->point(dim);
  if (const auto soft = value.find("soft")) handle.soft = soft->positive();
  const bool moved = value.has("translate") || value.has("rotate") || value.has("scale");
  if (const auto keyframes = value.find("keyframes")) {
    if (moved) value.fail("give either keyframes or translate, rotate and scale");
    handle.keyframes = read_keyframes(*keyframes, dim);
  } else if (moved) {
    handle.keyframes = {{0, {}}, {1, read_transform(value, dim)}};
    handle.keyframes[0].transform.axis = handle.keyframes[1].transform.axis;
  }
  return handle;
}

// From the first keyframe of all handles to the last; 0 to 1 without any.
void read_times(const JsonValue& scene, const std::vector<JsonValue>& values, Scene& result) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const JsonValue& value : values) {
    const auto keyframes = value.find("keyframes");
    if (!keyframes) continue;
    for (const JsonValue& key : keyframes->items()) {
      const double time = key.at("time").number();
      low = std::min(low, time), high = std::max(high, time);
      // The handles come from rest in a time as long again.
      if (!std::isfinite(low - (high - low)))
        key.at("time").fail("is too far from the other keyframes' times");
    }
  }
  if (low < high) result.start = low, result.end = high;
  if (low == high) scene.at("handles").fail("all keyframes are at one time");
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto& keys = result.handles[i].keyframes;
    if (keys.empty()) keys = {{result.start, {}}};
    if (!values[i].has("keyframes") && keys.size() == 2)
      keys[0].time = result.start, keys[1].time = result.end;
  }
}

void read_handles(const JsonValue& scene, int dim, Scene& result) {
  if (!scene.has("handles")) scene.fail("handles: there must be one at least");
  const auto values = scene.at("handles").items();
  std::set<std::string> names;
  for (const JsonValue& value : values) {
    result.handles.push_back(read_handle(value, dim));
    if (!names.insert(result.handles.back().name).second)
      value.fail("the name '" + result.handles.back().name + "' is taken");
  }
  if (values.empty()) scene.at("handles").fail("there must be one at least");
  read_times(scene, values, result);
}

}  // namespace

std::vector<std::string> scene_keys() {
  return {"mesh",    "order",  "quadrature", "energy", "material", "regions",
          "handles", "frames", "guess",      "format", "solver"};
}

BodySpec read_body_spec(const Json& json, const std::filesystem::path& folder) {
  const JsonValue scene(json);
  scene.only(scene_keys());
  BodySpec spec;
  const JsonValue mesh = scene.at("mesh");
  if (mesh.is_text())
    spec.file = folder / mesh.text();
  else
    spec.bar = read_bar(mesh.only({"bar"}).at("bar"));
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
  Scene result{json, read_energy(scene, dim, {})};
  if (const auto regions = scene.find("regions"))
    for (const JsonValue& value : regions->items()) result.regions.push_back(read_region(value, dim, scene));
  read_handles(scene, dim, result);
  if (const auto frames = scene.find("frames")) result.frames = frames->whole(1, 1'000'000);
  if (const auto guess = scene.find("guess")) result.guess = guess->choice(guess_names);
  if (const auto format = scene.find("format")) result.format = format->choice(frame_format_names);
  result.newton = read_solver(json);
  return result;
}

}  // namespace isostretch::app::deform

#include "scene_reader.hpp"

#include "common/body_reader.hpp"
#include "common/exit_code.hpp"
#include "common/handle_reader.hpp"
#include "common/json_value.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/figures/photo.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::app::manipulate {
namespace {

constexpr int most = std::numeric_limits<int>::max();

double not_negative(const JsonValue& value) {
  const double number = value.number();
  if (number < 0) value.fail("must not be negative");
  return number;
}

// So many square cells along the longer side of the picture, which has length 1.
GridSpec photo_grid(const JsonValue& value, const std::optional<PhotoSpec>& photo) {
  const int cells = value.only({"cells"}).at("cells").whole(1, most);
  if (!photo) value.fail("there is no picture; give 'photo'");
  // What is wrong in a picture is its own fault, whoever names it.
  const figures::Photo picture =
      with_error_kind(ErrorKind::input, [&] { return figures::read_photo(photo->file); });
  const double longer = std::max(picture.width(), picture.height());
  const double width = picture.width() / longer, height = picture.height() / longer;
  const auto count = [&](double size) { return std::max(1, static_cast<int>(std::lround(cells * size))); };
  return {{count(width), count(height)}, {width, height}, true};
}

void read_solver(const JsonValue& scene, sdp_penalty::Options& options) {
  if (const auto method = scene.find("method"))
    options.method = naming(*method, [&] { return sdp_penalty::method_from_name(method->text()); });
  if (const auto penalty = scene.find("penalty")) {
    options.penalty.penalty =
        naming(*penalty, [&] { return sdp_penalty::penalty_from_name(penalty->text()); });
    if (options.method != sdp_penalty::Method::penalty) penalty->fail("is of the method penalty alone");
  }
  if (const auto gap = scene.find("gap")) {
    options.gap_tolerance = gap->positive();
    if (options.gap_tolerance >= 1) gap->fail("must be below 1");
  }
  if (const auto count = scene.find("max_iterations"))
    options.max_iterations = count->whole(1, 1'000'000'000);
  // Frames must not depend on those before.
  options.augmented_lagrangian.warm_start = false;
  options.validate();
}

void read_rival(const JsonValue& scene, Scene& result) {
  const auto solver = scene.find("solver");
  if (!solver) return;
  result.rival = solver->text();
  std::vector<std::string> names;
  for (const baselines::SolverInfo& info : baselines::solvers()) names.emplace_back(info.name);
  if (std::find(names.begin(), names.end(), result.rival) == names.end())
    solver->fail("must be one of " + listed(names));
  for (const char* key : {"method", "penalty", "relinearize"})
    if (scene.has(key)) scene.at(key).fail("does not go with a solver");
}

void read_rotations(const JsonValue& scene, int dim, Scene& result) {
  if (const auto rotations = scene.find("rotations")) result.rotations = rotations->choice(rotations_names);
  result.blend = handles::default_blend(dim);
  if (const auto blend = scene.find("blend")) result.blend = blend->choice(blend_names);
}

}  // namespace

std::vector<std::string> scene_keys() {
  return {"mesh",
          "handles",
          "frames",
          "alpha",
          "weights",
          "units",
          "incompressibility",
          "margin",
          "rotations",
          "blend",
          "method",
          "gap",
          "max_iterations",
          "format",
          "photo",
          "up",
          "penalty",
          "largest_stretch",
          "relinearize",
          "solver"};
}

std::optional<PhotoSpec> read_photo_spec(const Json& json, const std::filesystem::path& folder) {
  const JsonValue scene(json);
  scene.only(scene_keys());
  const auto photo = scene.find("photo");
  if (!photo) return {};
  if (photo->is_text()) return PhotoSpec{folder / photo->text()};
  photo->only({"file", "fit"});
  PhotoSpec spec{folder / photo->at("file").text()};
  if (const auto fit = photo->find("fit")) spec.fit = fit->choice(photo_fit_names);
  return spec;
}

SolidSpec read_body_spec(const Json& json, const std::filesystem::path& folder, int refine) {
  const JsonValue scene(json);
  scene.only(scene_keys());
  SolidSpec spec;
  const JsonValue mesh = scene.at("mesh");
  if (mesh.has("photo_grid"))
    spec.generated = photo_grid(mesh.only({"photo_grid"}).at("photo_grid"), read_photo_spec(json, folder));
  else
    read_mesh(mesh, folder, spec);
  if (refine > 1) {
    if (!spec.generated)
      throw Error("--refine multiplies the cells of generated bodies, and the mesh is a file");
    spec.generated = deformation::refined(*spec.generated, refine);
  }
  return spec;
}

void require_linear(const SolidModel& body) {
  if (body.shape != mesh::Shape::tet && body.shape != mesh::Shape::triangle)
    throw Error("mesh: only linear triangles and tets are manipulated, not " +
                deformation::plural_name(body.shape));
}

Scene read_scene(const Json& json, int dim) {
  const JsonValue scene(json);
  Scene result{{}, json};
  result.script = read_handle_script(scene, dim, Holding::soft, 1);
  if (const auto alpha = scene.find("alpha")) result.alpha = alpha->positive();
  if (const auto weights = scene.find("weights")) result.weights = weights->choice(weights_names);
  if (const auto units = scene.find("units")) result.units = units->choice(units_names);
  if (const auto kappa = scene.find("incompressibility")) result.incompressibility = not_negative(*kappa);
  if (const auto margin = scene.find("margin")) {
    result.margin = not_negative(*margin);
    if (result.margin >= 1) margin->fail("must be below 1, the eigenvalue at rest");
  }
  if (const auto bound = scene.find("largest_stretch")) {
    result.largest_stretch = bound->number();
    if (result.largest_stretch <= 1) bound->fail("must be above 1, the stretch at rest");
  }
  if (const auto rounds = scene.find("relinearize")) result.relinearize = rounds->whole(0, most);
  if (const auto format = scene.find("format")) result.format = format->choice(frame_format_names);
  if (const auto up = scene.find("up")) result.up = up->choice(up_names);
  if (dim != 2 && scene.has("photo")) scene.at("photo").fail("pictures are drawn on bodies in the plane");
  read_rotations(scene, dim, result);
  read_solver(scene, result.solver);
  read_rival(scene, result);
  if (std::isfinite(result.largest_stretch) && result.solver.method != sdp_penalty::Method::interior_point)
    scene.at("largest_stretch").fail("is known to the method interior_point alone");
  if (result.relinearize > 0 && result.solver.method == sdp_penalty::Method::skinning)
    scene.at("relinearize").fail("needs a method that minimises with the constraint");
  return result;
}

}  // namespace isostretch::app::manipulate

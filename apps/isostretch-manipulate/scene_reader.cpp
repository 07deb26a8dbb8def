#include "scene_reader.hpp"

#include "common/exit_code.hpp"

#include <isostretch/baselines/solver.hpp>
#include <isostretch/figures/photo.hpp>
#include <isostretch/scene/pipelines.hpp>
#include <isostretch/scene/solid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::app::manipulate {
namespace {

using scene::Node;

constexpr int most = std::numeric_limits<int>::max();

// So many square cells along the longer side of the picture, which has length 1.
GridSpec photo_grid(const Node& value, const std::optional<PhotoSpec>& photo) {
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

std::string read_rival(const Node& scene) {
  const auto rival = scene.find("rival");
  if (!rival) return {};
  std::vector<std::string> names;
  for (const baselines::SolverInfo& info : baselines::solvers()) names.emplace_back(info.name);
  if (std::find(names.begin(), names.end(), rival->text()) == names.end())
    rival->fail("must be one of " + listed(names));
  if (const auto group = scene.find("manipulation"))
    for (const char* key : {"method", "penalty", "relinearize"})
      if (group->has(key)) group->at(key).fail("does not go with a rival");
  return rival->text();
}

}  // namespace

std::optional<PhotoSpec> read_photo_spec(const scene::Value& value, const std::filesystem::path& folder) {
  const Node scene(value);
  const auto photo = scene.find("photo");
  if (!photo) return {};
  if (photo->value().is_text()) return PhotoSpec{folder / photo->text()};
  photo->only({"file", "fit"});
  PhotoSpec spec{folder / photo->at("file").text()};
  if (const auto fit = photo->find("fit")) spec.fit = fit->choice(choice_names(PhotoFit{}));
  return spec;
}

SolidSpec read_body_spec(const scene::Value& value, const std::filesystem::path& folder, int refine) {
  const Node scene(value);
  SolidSpec spec;
  const Node mesh = scene.at("mesh");
  if (mesh.has("photo_grid"))
    spec.generated = photo_grid(mesh.only({"photo_grid"}).at("photo_grid"), read_photo_spec(value, folder));
  else
    spec = scene::read_solid(scene, folder);
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

Scene read_scene(const scene::Value& value, int dim) {
  const Node scene(value);
  Scene result{scene::read_manipulation(scene, dim), value};
  if (const auto format = scene.find("format")) result.format = format->choice(choice_names(FrameFormat{}));
  if (const auto up = scene.find("up")) result.up = up->choice(up_names);
  if (dim != 2 && scene.has("photo")) scene.at("photo").fail("pictures are drawn on bodies in the plane");
  result.rival = read_rival(scene);
  return result;
}

}  // namespace isostretch::app::manipulate

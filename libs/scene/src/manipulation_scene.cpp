#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/scene/manipulation_scene.hpp>
#include <isostretch/scene/node.hpp>
#include <isostretch/scene/pipelines.hpp>
#include <isostretch/scene/solid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostretch::scene {
namespace {

constexpr int most = std::numeric_limits<int>::max();

// So many square cells along the longer side of the picture, which has length 1.
deformation::GridSpec photo_grid(const Node& value, const std::optional<PhotoSpec>& photo,
                                 const PhotoSize& photo_size) {
  const int cells = value.only({"cells"}).at("cells").whole(1, most);
  if (!photo) value.fail("there is no picture; give 'photo'");
  // What is wrong in a picture is its own fault, whoever names it.
  const std::array<int, 2> picture =
      with_error_kind(ErrorKind::input, [&] { return photo_size(photo->file); });
  const double longer = std::max(picture[0], picture[1]);
  const double width = picture[0] / longer, height = picture[1] / longer;
  const auto count = [&](double size) { return std::max(1, static_cast<int>(std::lround(cells * size))); };
  return {{count(width), count(height)}, {width, height}, true};
}

// What is up in pictures.
constexpr ChoiceNames<int, 3> up_names{{{"x", 0}, {"y", 1}, {"z", 2}}};

std::string read_rival(const Node& scene, const std::vector<std::string>& names) {
  const auto rival = scene.find("rival");
  if (!rival) return {};
  if (std::find(names.begin(), names.end(), rival->text()) == names.end())
    rival->fail("must be one of " + listed(names));
  if (const auto group = scene.find("manipulation"))
    for (const char* key : {"method", "penalty", "relinearize"})
      if (group->has(key)) group->at(key).fail("does not go with a rival");
  return rival->text();
}

}  // namespace

std::optional<PhotoSpec> read_photo_spec(const Value& value, const std::filesystem::path& folder) {
  const Node scene(value);
  const auto photo = scene.find("photo");
  if (!photo) return {};
  if (photo->value().is_text()) return PhotoSpec{folder / photo->text()};
  photo->only({"file", "fit"});
  PhotoSpec spec{folder / photo->at("file").text()};
  if (const auto fit = photo->find("fit")) spec.fit = fit->choice(choice_names(PhotoFit{}));
  return spec;
}

deformation::SolidSpec read_manipulated_solid(const Value& value, const std::filesystem::path& folder,
                                              int refine, const PhotoSize& photo_size) {
  const Node scene(value);
  deformation::SolidSpec spec;
  const Node mesh = scene.at("mesh");
  if (mesh.has("photo_grid"))
    spec.generated =
        photo_grid(mesh.only({"photo_grid"}).at("photo_grid"), read_photo_spec(value, folder), photo_size);
  else
    spec = read_solid(scene, folder);
  if (refine > 1) {
    if (!spec.generated)
      throw Error("--refine multiplies the cells of generated bodies, and the mesh is a file");
    spec.generated = deformation::refined(*spec.generated, refine);
  }
  return spec;
}

void require_linear(const deformation::SolidModel& body) {
  if (body.shape != mesh::Shape::tet && body.shape != mesh::Shape::triangle)
    throw Error("mesh: only linear triangles and tets are manipulated, not " +
                deformation::plural_name(body.shape));
}

ManipulationScene read_manipulation_scene(const Value& value, int dim,
                                          const std::vector<std::string>& rivals) {
  const Node scene(value);
  ManipulationScene result{read_manipulation(scene, dim), value};
  if (const auto format = scene.find("format"))
    result.format = format->choice(choice_names(deformation::FrameFormat{}));
  if (const auto up = scene.find("up")) result.up = up->choice(up_names);
  if (dim != 2 && scene.has("photo")) scene.at("photo").fail("pictures are drawn on bodies in the plane");
  result.rival = read_rival(scene, rivals);
  return result;
}

void set_photo(Value& scene, const std::optional<std::string>& file, const std::optional<std::string>& fit) {
  if (file)
    scene["photo"] = Value::object("file", *file);
  else if (fit && scene.has("photo") && scene["photo"].is_text())
    scene["photo"] = Value::object("file", scene["photo"]);
  if (!fit) return;
  if (!scene.has("photo") || !scene["photo"].is_object())
    throw Error(ErrorKind::misuse, "--photo-fit says how a picture lies, and there is none");
  scene["photo"]["fit"] = *fit;
}

void set_rival(Value& scene, const std::string& rival) {
  scene["rival"] = rival;
  Value* group = scene.find("manipulation");
  if (group == nullptr || !group->is_object()) return;
  group->take("method");
  group->take("penalty");
}

}  // namespace isostretch::scene

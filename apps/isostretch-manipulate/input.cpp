#include "input.hpp"

#include "common/scene_input.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/photo.hpp>

namespace isostretch::app::manipulate {
namespace {

std::array<int, 2> photo_size(const std::filesystem::path& file) {
  const figures::Photo photo = figures::read_photo(file);
  return {photo.width(), photo.height()};
}

SolidSpec read_spec(const CommandLine& command_line, const scene::Value& value) {
  SolidSpec spec = reading_scene(command_line.input(), [&] {
    return scene::read_manipulated_solid(value, command_line.folder(), command_line.refine(), photo_size);
  });
  spec.repair = command_line.repair();
  return spec;
}

}  // namespace

SolidModel read_body(const CommandLine& command_line, const scene::Value& value) {
  const SolidSpec spec = read_spec(command_line, value);
  return reading_body(command_line.input(), spec, [&] {
    SolidModel body = deformation::load_solid(spec);
    scene::require_linear(body);
    return body;
  });
}

SolidCheck check_solid(const CommandLine& command_line, const scene::Value& value) {
  const SolidSpec spec = read_spec(command_line, value);
  return reading_body(command_line.input(), spec,
                      [&] { return deformation::check_solid(spec, scene::require_linear); });
}

Scene read_scene(const CommandLine& command_line, const scene::Value& value, const SolidModel& body) {
  return reading_scene(command_line.input(), [&] {
    Scene result = scene::read_manipulation_scene(value, body.dim, rival_names());
    require_holds(result.format, body);
    return result;
  });
}

HandleSet read_rig(const CommandLine& command_line, const Scene& scene, const SolidModel& body) {
  return reading_scene(command_line.input(), [&] { return HandleSet(scene.script, body); });
}

FrameRange read_range(const Options& options, const Scene& scene) {
  const FrameRange range = options.range.value_or(FrameRange{1, scene.script.frames});
  if (range.last > scene.script.frames)
    throw Error(ErrorKind::misuse, formatted("--frames: there is no frame %d, the scene has %d", range.last,
                                             scene.script.frames));
  return range;
}

}  // namespace isostretch::app::manipulate

#include "input.hpp"

#include "common/scene_input.hpp"
#include "scene_reader.hpp"

#include <isostretch/core/text.hpp>

namespace isostretch::app::manipulate {
namespace {

SolidSpec read_spec(const CommandLine& command_line, const scene::Value& scene) {
  SolidSpec spec = reading_scene(command_line.input(), [&] {
    return read_body_spec(scene, command_line.folder(), command_line.refine());
  });
  spec.repair = command_line.repair();
  return spec;
}

}  // namespace

SolidModel read_body(const CommandLine& command_line, const scene::Value& scene) {
  const SolidSpec spec = read_spec(command_line, scene);
  return reading_body(command_line.input(), spec, [&] {
    SolidModel body = deformation::load_solid(spec);
    require_linear(body);
    return body;
  });
}

SolidCheck check_solid(const CommandLine& command_line, const scene::Value& scene) {
  const SolidSpec spec = read_spec(command_line, scene);
  return reading_body(command_line.input(), spec,
                      [&] { return deformation::check_solid(spec, require_linear); });
}

Scene read_scene(const CommandLine& command_line, const scene::Value& scene, const SolidModel& body) {
  return reading_scene(command_line.input(), [&] {
    Scene result = read_scene(scene, body.dim);
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

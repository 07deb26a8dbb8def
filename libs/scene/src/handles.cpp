#include <isostretch/scene/handles.hpp>

#include "definitions.hpp"

#include <isostretch/scene/selection.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace isostretch::scene {
namespace {

using deformation::HandleScript;
using deformation::HandleSpec;

void read_rotation(const Node& value, int dim, handles::Transform& transform) {
  value.only(keys_of("rotation"));
  transform.degrees = value.at("degrees").number();
  if (dim == 2) {
    if (const auto axis = value.find("axis")) axis->fail("in the plane there is one axis; leave it out");
    return;
  }
  transform.axis = value.at("axis").point(3);
  if (transform.axis.isZero(0)) value.at("axis").fail("has length zero");
}

handles::Transform read_transform(const Node& value, int dim) {
  handles::Transform transform;
  if (const auto translate = value.find("translate")) transform.translation = translate->point(dim);
  if (const auto rotate = value.find("rotate")) read_rotation(*rotate, dim, transform);
  if (const auto scale = value.find("scale")) transform.scale = scale->positive();
  return transform;
}

std::vector<handles::Keyframe> read_keyframes(const Node& value, int dim) {
  std::vector<handles::Keyframe> keys;
  for (const Node& item : value.items()) {
    item.only(keys_of("keyframe"));
    keys.push_back({item.at("time").number(), read_transform(item, dim)});
    if (keys.size() > 1 && !(keys[keys.size() - 2].time < keys.back().time))
      item.at("time").fail("must be later than that of the keyframe before");
  }
  if (keys.empty()) value.fail("there must be one at least");
  return keys;
}

// A single key at time 1 stands for "from rest to there over the whole time", until the time is known.
HandleSpec read_handle(const Node& value, int dim, Holding holding) {
  value.only(keys_of("handle"));
  HandleSpec handle;
  handle.path = handle.name = value.path();
  if (const auto name = value.find("name")) handle.name = name->text();
  handle.select = read_selection(value.at("select"), dim);
  if (const auto center = value.find("center")) handle.center = center->point(dim);
  const auto hard = value.find("hard"), soft = value.find("soft");
  if (soft && hard) hard->fail("give either soft or hard");
  if (soft && holding == Holding::soft) soft->fail("handles are soft here, all with the weight 'alpha'");
  if (soft) handle.soft = soft->positive();
  if (!soft && !(hard ? hard->truth() : holding == Holding::hard)) handle.soft = 1;
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
void read_times(const Node& scene, const std::vector<Node>& values, HandleScript& result) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Node& value : values) {
    const auto keyframes = value.find("keyframes");
    if (!keyframes) continue;
    for (const Node& key : keyframes->items()) {
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

}  // namespace

HandleScript read_handle_script(const Node& scene, int dim, Holding holding, int frames) {
  HandleScript result;
  result.frames = frames;
  if (const auto count = scene.find("frames")) result.frames = count->whole(1, 1'000'000);
  if (!scene.has("handles")) scene.fail("handles: there must be one at least");
  const auto values = scene.at("handles").items();
  std::set<std::string> names;
  for (const Node& value : values) {
    result.handles.push_back(read_handle(value, dim, holding));
    if (!names.insert(result.handles.back().name).second)
      value.fail("the name '" + result.handles.back().name + "' is taken");
  }
  if (values.empty()) scene.at("handles").fail("there must be one at least");
  read_times(scene, values, result);
  return result;
}

}  // namespace isostretch::scene

#include "state.hpp"

#include "common/exit_code.hpp"
#include "common/scene_input.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/scene/node.hpp>

#include <algorithm>
#include <limits>
#include <set>

namespace isostretch::app::deform {
namespace {

constexpr int most = std::numeric_limits<int>::max();

using scene::Node;
using scene::Value;

// The order of keys does not matter.
bool same(const Value& a, const Value& b) {
  if (a.is_list() && b.is_list())
    return std::equal(a.items().begin(), a.items().end(), b.items().begin(), b.items().end(), same);
  if (!a.is_object() || !b.is_object()) return a == b;
  return a.size() == b.size() &&
         std::all_of(a.members().begin(), a.members().end(), [&](const scene::Member& member) {
           return b.has(member.key) && same(member.value, *b.find(member.key));
         });
}

void require_same_scene(const Value& before, const Value& now) {
  std::set<std::string> keys;
  for (const Value* scene : {&before, &now})
    for (const scene::Member& member : scene->members()) keys.insert(member.key);
  for (const std::string& key : keys)
    if (!before.has(key) || !now.has(key) || !same(*before.find(key), *now.find(key)))
      throw Error("belongs to another scene: '" + key + "' has changed; run without --restart to begin anew");
}

// The limit of time ends frames, and changes none.
Value without_time_limit(Value scene) {
  if (Value* newton = scene.find("newton")) {
    newton->take("time_limit");
    if (newton->size() == 0) scene.take("newton");
  }
  return scene;
}

void require_same(const Value& value, const Scene& scene, const SolidModel& body) {
  const Node state(value);
  if (!state.at("scene").value().is_object()) state.fail("is damaged: scene: must be an object {...}");
  require_same_scene(without_time_limit(state.at("scene").value()), without_time_limit(scene.value));
  if (state.at("body").text() != body.fingerprint())
    throw Error("belongs to another mesh; run without --restart to begin anew");
}

bool is_text(const Value* value, std::string_view text) {
  return value != nullptr && value->is_text() && value->text() == text;
}

bool same_version(const Value& value) {
  return is_text(value.find("instruction_set"), isa_name(active_isa())) &&
         is_text(value.find("version"), version_string);
}

// What the reports read of a frame later.
void require_frame(const Node& value, int number, const SolidModel& body) {
  const int elements = body.elements.element_count();
  value.at("frame").whole(number, number);
  value.at("time").number();
  value.at("file").text();
  value.at("status").text();
  value.at("parts").whole(0, most);
  value.at("min_det_F_element").whole(0, elements - 1);
  value.at("inverted").whole(0, elements);
  for (const char* key : {"reached", "converged"}) value.at(key).truth();
  for (const char* key : {"iterations", "factorizations"}) value.at(key).whole(0, most);
  for (const char* key : {"min_det_F", "max_length_change"})  // null: was not finite
    if (!value.at(key).value().is_null()) value.at(key).number();
  if (const auto seconds = value.find("seconds")) seconds->number();
}

State state_in(const Node& value, const Scene& scene, const SolidModel& body) {
  State state;
  state.frame = value.at("frame").whole(0, scene.script.frames);
  const auto frames = value.at("frames").items();
  if (frames.size() != static_cast<std::size_t>(state.frame) + 1)
    value.at("frames").fail("must be " + std::to_string(state.frame + 1) + ", not " +
                            std::to_string(frames.size()));
  for (std::size_t i = 0; i < frames.size(); ++i) require_frame(frames[i], static_cast<int>(i), body);
  state.frames = report_json(value.at("frames").value());
  state.trace = value.at("trace").text();
  const auto positions = value.at("positions").numbers();
  if (positions.size() != static_cast<std::size_t>(body.dim * body.nodes.rows()))
    value.at("positions")
        .fail("must be " + std::to_string(body.dim * body.nodes.rows()) + ", not " +
              std::to_string(positions.size()));
  state.positions = Vector::Map(positions.data(), static_cast<Eigen::Index>(positions.size()));
  return state;
}

}  // namespace

std::string state_text(const State& state, const Scene& scene, const SolidModel& body) {
  const Json json{{"version", version_string},
                  {"instruction_set", isa_name(active_isa())},
                  {"scene", report_json(scene.value)},
                  {"body", body.fingerprint()},
                  {"frame", state.frame},
                  {"frames", state.frames},
                  {"trace", state.trace},
                  {"positions", std::vector<double>(state.positions.begin(), state.positions.end())}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

State read_state(const std::filesystem::path& folder, const Scene& scene, const SolidModel& body) {
  const std::filesystem::path file = folder / state_file;
  if (!std::filesystem::exists(file))
    throw Error(file.string() + ": not there, so there is nothing for --restart to go on from");
  const Value value = scene::read_json(file);
  with_error_prefix(file.string(), [&] { require_same(value, scene, body); });
  if (!same_version(value))
    warn(file.string() +
         ": was made by another version or at another instruction-set level; "
         "the frames to come agree with an uninterrupted run to rounding only");
  try {
    return state_in(Node(value), scene, body);
  } catch (const Error& error) {
    throw Error(file.string() + " is damaged: " + error.what());
  }
}

}  // namespace isostretch::app::deform

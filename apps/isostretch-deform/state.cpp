#include "state.hpp"

#include "common/exit_code.hpp"
#include "common/json_value.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/version.hpp>

#include <limits>
#include <set>

namespace isostretch::app::deform {
namespace {

constexpr int most = std::numeric_limits<int>::max();

// The order of keys does not matter.
nlohmann::json sorted(const Json& json) {
  return nlohmann::json(json);
}

void require_same_scene(const Json& before, const Json& now) {
  std::set<std::string> keys;
  for (const Json* scene : {&before, &now})
    for (const auto& [key, value] : scene->items()) keys.insert(key);
  for (const std::string& key : keys) {
    const bool same = before.contains(key) == now.contains(key) &&
                      (!now.contains(key) || sorted(before[key]) == sorted(now[key]));
    if (!same)
      throw Error("belongs to another scene: '" + key + "' has changed; run without --restart to begin anew");
  }
}

void require_same(const Json& json, const Scene& scene, const SolidModel& body) {
  const JsonValue state(json);
  if (!state.at("scene").is_object()) state.fail("is damaged: scene: must be an object {...}");
  require_same_scene(json["scene"], scene.json);
  if (state.at("body").text() != body.fingerprint())
    throw Error("belongs to another mesh; run without --restart to begin anew");
}

bool same_version(const Json& json) {
  return json.value("instruction_set", Json()) == isa_name(active_isa()) &&
         json.value("version", Json()) == version_string;
}

// What the reports read of a frame later.
void require_frame(const JsonValue& value, int number, const SolidModel& body) {
  const int elements = body.elements.element_count();
  value.at("frame").whole(number, number);
  value.at("time").number();
  value.at("file").text();
  value.at("status").text();
  value.at("parts").whole(0, most);
  value.at("min_det_F_element").whole(0, elements - 1);
  value.at("inverted").whole(0, elements);
  for (const char* key : {"reached", "converged"})
    if (!value.at(key).json().is_boolean()) value.at(key).fail("must be true or false");
  for (const char* key : {"iterations", "factorizations"}) value.at(key).whole(0, most);
  for (const char* key : {"min_det_F", "max_length_change"})  // null: was not finite
    if (!value.at(key).json().is_null()) value.at(key).number();
  if (const auto seconds = value.find("seconds")) seconds->number();
}

State state_in(const JsonValue& value, const Scene& scene, const SolidModel& body) {
  State state;
  state.frame = value.at("frame").whole(0, scene.script.frames);
  const auto frames = value.at("frames").items();
  if (frames.size() != static_cast<std::size_t>(state.frame) + 1)
    value.at("frames").fail("must be " + std::to_string(state.frame + 1) + ", not " +
                            std::to_string(frames.size()));
  for (std::size_t i = 0; i < frames.size(); ++i) require_frame(frames[i], static_cast<int>(i), body);
  state.frames = value.at("frames").json();
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

std::string state_text(const State& state, const Json& scene, const SolidModel& body) {
  const Json json{{"version", version_string},
                  {"instruction_set", isa_name(active_isa())},
                  {"scene", scene},
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
  const Json json = read_json_file(file);
  with_error_prefix(file.string(), [&] { require_same(json, scene, body); });
  if (!same_version(json))
    warn(file.string() +
         ": was made by another version or at another instruction-set level; "
         "the frames to come agree with an uninterrupted run to rounding only");
  try {
    return state_in(JsonValue(json), scene, body);
  } catch (const Error& error) {
    throw Error(file.string() + " is damaged: " + error.what());
  }
}

}  // namespace isostretch::app::deform

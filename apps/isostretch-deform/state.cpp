#include "state.hpp"

#include "common/json_value.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/version.hpp>

#include <set>

namespace isostretch::app::deform {
namespace {

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

}  // namespace

std::string state_text(const State& state, const Json& scene, const Body& body) {
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

State read_state(const std::filesystem::path& folder, const Json& scene, const Body& body) {
  const std::filesystem::path file = folder / state_file;
  if (!std::filesystem::exists(file))
    throw Error(file.string() + ": not there, so there is nothing for --restart to go on from");
  const Json json = read_json_file(file);
  try {
    require_same_scene(json.at("scene"), scene);
    if (json.at("body") != body.fingerprint())
      throw Error("belongs to another mesh; run without --restart to begin anew");
    const auto positions = json.at("positions").get<std::vector<double>>();
    if (positions.size() != static_cast<std::size_t>(body.dim * body.nodes.rows()))
      throw Error("has " + std::to_string(positions.size()) + " positions");
    if (json.at("instruction_set") != isa_name(active_isa()) || json.at("version") != version_string)
      warn(file.string() +
           ": was made by another version or at another instruction-set level; "
           "the frames to come agree with an uninterrupted run to rounding only");
    return {json.at("frame").get<int>(), json.at("frames"), json.at("trace").get<std::string>(),
            Vector::Map(positions.data(), static_cast<Eigen::Index>(positions.size()))};
  } catch (const Json::exception& error) {
    throw Error(file.string() + ": is damaged: " + error.what());
  } catch (const Error& error) {
    throw Error(file.string() + ": " + error.what());
  }
}

}  // namespace isostretch::app::deform

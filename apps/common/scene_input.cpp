#include "common/scene_input.hpp"

#include "common/json_value.hpp"

#include <nlohmann/json.hpp>

namespace isostretch::app {

Json scene_object(const std::filesystem::path& input, const std::vector<std::string>& keys) {
  if (!is_scene_file(input)) return Json::object();
  return failing_with(ExitCode::input, [&] {
    const Json json = read_json_file(input);
    naming_file(input, [&] { JsonValue(json).only(keys); });
    return json;
  });
}

}  // namespace isostretch::app

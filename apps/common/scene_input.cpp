#include "common/scene_input.hpp"

#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/scene/scene_file.hpp>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace isostretch::app {
namespace {

namespace fs = std::filesystem;

// A folder does not count: results often have the name of their scene.
bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

const EmbeddedScene* scene_named(const fs::path& input, const std::vector<EmbeddedScene>& embedded) {
  const bool may_be = !input.has_parent_path() && (!input.has_extension() || is_scene_file(input));
  const auto found = std::find_if(embedded.begin(), embedded.end(), [&](const EmbeddedScene& scene) {
    return may_be && input.stem() == scene.name;
  });
  return found == embedded.end() ? nullptr : &*found;
}

[[noreturn]] void fail_unknown(const fs::path& input) {
  throw Error(ErrorKind::input, input.string() +
                                    ": there is no file of that name, and no scene of that name comes with "
                                    "the program (--list-scenes shows them)");
}

// What a scene shows is the comment that it begins with.
std::string_view first_comment(std::string_view text) {
  text = text.substr(0, text.find('\n'));
  const std::size_t at = text.find("// ");
  return at == std::string_view::npos ? std::string_view() : text.substr(at + 3);
}

std::string scene_list(const std::vector<EmbeddedScene>& embedded) {
  std::size_t width = 0;
  for (const EmbeddedScene& scene : embedded) width = std::max(width, scene.name.size());
  std::string text;
  for (const EmbeddedScene& scene : embedded)
    text.append(scene.name)
        .append(width + 2 - scene.name.size(), ' ')
        .append(first_comment(scene.text))
        .append("\n");
  return text;
}

scene::Value upgraded(scene::Value scene, const fs::path& input, const std::vector<std::string>& used) {
  const std::string renamed = scene::renamed_text(scene::upgrade(scene));
  if (!renamed.empty()) notice(input.string() + ": " + renamed);
  scene::check_keys(scene);
  for (const std::string& key : scene::scene_keys()) {
    if (!scene.has(key) || std::find(used.begin(), used.end(), key) != used.end()) continue;
    warn(input.string() + ": '" + key + "' is of no use to this app");
    scene.take(key);
  }
  return scene;
}

}  // namespace

scene::Value read_scene_input(const fs::path& input, const std::vector<std::string>& used,
                              const std::vector<EmbeddedScene>& embedded) {
  const bool is_name = !embedded.empty() && !input.empty() && !input.has_parent_path() && !is_file(input);
  const EmbeddedScene* known = is_name ? scene_named(input, embedded) : nullptr;
  if (is_name && known == nullptr && (!input.has_extension() || is_scene_file(input))) fail_unknown(input);
  if (!is_scene_file(input)) return scene::Value::object("schema", scene::schema_version);
  return with_error_kind(ErrorKind::input, [&] {
    const scene::Value scene = known != nullptr ? scene::parse_json(std::string(known->text), input.string())
                                                : scene::read_json(input);
    return with_error_prefix(input.string(), [&] { return upgraded(scene, input, used); });
  });
}

Json report_json(const scene::Value& value) {
  return Json::parse(scene::to_json(value));
}

void take_scene_names(CLI::Option& option, const std::vector<EmbeddedScene>& embedded) {
  option.transform(CLI::Validator(
      [&embedded](std::string& input) {
        if (!is_file(input) && !is_scene_file(input) && scene_named(input, embedded) != nullptr)
          input += ".json";
        return std::string();
      },
      ""));
}

void declare_scene_list(CLI::App& cli, const std::vector<EmbeddedScene>& embedded) {
  cli.add_flag_callback(
         "--list-scenes",
         [&embedded] {
           std::cout << scene_list(embedded) << std::flush;
           throw CLI::Success{};
         },
         "List the scenes that come with the program and what they show, and exit")
      ->trigger_on_parse();
}

}  // namespace isostretch::app

#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/scene/scene_file.hpp>
#include <isostretch/scene/scene_input.hpp>

#include <algorithm>

namespace isostretch::scene {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_unknown(const fs::path& input) {
  throw Error(ErrorKind::input, input.string() +
                                    ": there is no file of that name, and no scene of that name comes with "
                                    "the program (--list-scenes shows them)");
}

std::string_view first_comment(std::string_view text) {
  text = text.substr(0, text.find('\n'));
  const std::size_t at = text.find("// ");
  return at == std::string_view::npos ? std::string_view() : text.substr(at + 3);
}

Value upgraded(Value scene, const fs::path& input, const std::vector<std::string>& used) {
  const std::string renamed = renamed_text(upgrade(scene));
  if (!renamed.empty()) log(LogLevel::info, input.string() + ": " + renamed);
  check_keys(scene);
  for (const std::string& key : scene_keys()) {
    if (!scene.has(key) || std::find(used.begin(), used.end(), key) != used.end()) continue;
    log(LogLevel::warning, input.string() + ": '" + key + "' is of no use to this app");
    scene.take(key);
  }
  return scene;
}

}  // namespace

bool is_scene_file(const fs::path& input) {
  return input.extension() == ".json";
}

fs::path scene_folder(const fs::path& input) {
  return is_scene_file(input) ? input.parent_path() : fs::path();
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

const EmbeddedScene* embedded_scene(const fs::path& input, const std::vector<EmbeddedScene>& embedded) {
  const bool may_be = !input.has_parent_path() && (!input.has_extension() || is_scene_file(input));
  const auto found = std::find_if(embedded.begin(), embedded.end(), [&](const EmbeddedScene& scene) {
    return may_be && input.stem() == scene.name;
  });
  return found == embedded.end() ? nullptr : &*found;
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

Value read_scene_input(const fs::path& input, const std::vector<std::string>& used,
                       const std::vector<EmbeddedScene>& embedded) {
  const bool is_name = !embedded.empty() && !input.empty() && !input.has_parent_path() && !is_file(input);
  const EmbeddedScene* known = is_name ? embedded_scene(input, embedded) : nullptr;
  if (is_name && known == nullptr && (!input.has_extension() || is_scene_file(input))) fail_unknown(input);
  if (!is_scene_file(input)) return Value::object("schema", schema_version);
  return with_error_kind(ErrorKind::input, [&] {
    const Value scene =
        known != nullptr ? parse_json(std::string(known->text), input.string()) : read_json(input);
    return with_error_prefix(input.string(), [&] { return upgraded(scene, input, used); });
  });
}

}  // namespace isostretch::scene

// JSON is nlohmann's business; what it reads becomes a Value at once, and no header of this library names it.
#include <isostretch/scene/value.hpp>

#include <isostretch/core/error.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

namespace isostretch::scene {
namespace {

using Json = nlohmann::ordered_json;

// "[json.exception.parse_error.101] parse error at line 3, ...", without the library's number.
std::string without_number(const std::string& message) {
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

// Deeper ones are no input of ours, and code that goes down into them would run out of stack.
constexpr int deepest = 64;

// Follows the parser, which takes the last of two equal keys without a word.
class DuplicateKeys {
 public:
  void see(Json::parse_event_t event, const Json& value) {
    using Event = Json::parse_event_t;
    if (event == Event::key) {
      add_key(value.get<std::string>());
    } else if (event == Event::object_end || event == Event::array_end) {
      open_.pop_back();
    } else {
      if (!open_.empty() && open_.back().is_list) ++open_.back().item;
      if (event != Event::value) open_.push_back({event == Event::array_start, -1, {}, {}});
    }
  }

 private:
  struct Level {
    bool is_list;
    long item;
    std::string key;
    std::set<std::string> keys;
  };

  void add_key(const std::string& key) {
    open_.back().key = key;
    if (!open_.back().keys.insert(key).second) throw Error(path() + ": the key is given twice");
  }

  std::string path() const {
    std::string text;
    for (const Level& level : open_) {
      if (level.is_list)
        text.append("[").append(std::to_string(level.item)).append("]");
      else
        text.append(text.empty() ? "" : ".").append(level.key);
    }
    return text;
  }

  std::vector<Level> open_;
};

Json parsed(const std::string& text) {
  DuplicateKeys keys;
  const auto check = [&keys](int depth, Json::parse_event_t event, Json& value) {
    if (depth > deepest)
      throw Error("lists and objects inside each other, more than " + std::to_string(deepest) + " deep");
    keys.see(event, value);
    return true;
  };
  return Json::parse(text, check, true, true);
}

Value value_of(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  if (json.is_array()) {
    Value::List items;
    for (const Json& item : json) items.push_back(value_of(item));
    return Value::list(std::move(items));
  }
  if (!json.is_object()) return {};
  Value::Object members;
  for (const auto& [key, value] : json.items()) members.push_back({key, value_of(value)});
  return Value::object(std::move(members));
}

// Whole numbers are written as such, up to where doubles have gaps between them.
Json json_of_number(double number) {
  constexpr double largest = 9007199254740992.0;
  if (number == std::floor(number) && std::abs(number) <= largest && !(number == 0 && std::signbit(number)))
    return static_cast<long long>(number);
  return std::isfinite(number) ? Json(number) : Json();
}

Json json_of(const Value& value) {
  if (value.is_truth()) return value.truth();
  if (value.is_number()) return json_of_number(value.number());
  if (value.is_text()) return value.text();
  if (value.is_null()) return {};
  Json json = value.is_list() ? Json::array() : Json::object();
  if (value.is_list())
    for (const Value& item : value.items()) json.push_back(json_of(item));
  else
    for (const Member& member : value.members()) json[member.key] = json_of(member.value);
  return json;
}

}  // namespace

Value parse_json(const std::string& text, const std::string& name) {
  try {
    return value_of(parsed(text));
  } catch (const Json::exception& error) {  // wrong grammar, and numbers that no double can hold
    throw Error(name + ": " + without_number(error.what()));
  } catch (const Error& error) {
    throw Error(name + ": " + error.what());
  }
}

Value read_json(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!std::filesystem::is_regular_file(file) || !in || !(text << in.rdbuf()))
    throw Error(file.string() + ": cannot be read");
  return parse_json(text.str(), file.string());
}

std::string to_json(const Value& value, int indent) {
  return json_of(value).dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace isostretch::scene

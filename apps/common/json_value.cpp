#include "common/json_value.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace isostretch::app {
namespace {

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

// Of any value in a few words.
std::string described(const Json& json) {
  if (json.is_object()) return "an object of " + std::to_string(json.size());
  if (json.is_array()) return "a list of " + std::to_string(json.size());
  return json.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 60);
}

}  // namespace

Json read_json_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!std::filesystem::is_regular_file(file) || !in || !(text << in.rdbuf()))
    throw Error(file.string() + ": cannot be read");
  return parse_json(text.str(), file.string());
}

Json parse_json(const std::string& text, const std::string& name) {
  try {
    return parsed(text);
  } catch (const Json::exception& error) {  // wrong grammar, and numbers that no double can hold
    throw Error(name + ": " + without_number(error.what()));
  } catch (const Error& error) {
    throw Error(name + ": " + error.what());
  }
}

void JsonValue::fail(const std::string& what) const {
  throw Error(path_.empty() ? what : path_ + ": " + what);
}

void JsonValue::require_kind(bool is, const char* kind) const {
  if (!is) fail(std::string("must be ") + kind + ", not " + described(*json_));
}

const JsonValue& JsonValue::only(const std::vector<std::string>& keys) const {
  require_kind(json_->is_object(), "an object {...}");
  for (const auto& [key, value] : json_->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      fail("unknown key '" + key + "'; there are " + listed(keys));
  return *this;
}

bool JsonValue::has(const std::string& key) const {
  return json_->is_object() && json_->contains(key);
}

JsonValue JsonValue::at(const std::string& key) const {
  require_kind(json_->is_object(), "an object {...}");
  if (!json_->contains(key)) fail("the key '" + key + "' is missing");
  return JsonValue((*json_)[key], path_.empty() ? key : path_ + "." + key);
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
  return has(key) ? std::optional(at(key)) : std::nullopt;
}

double JsonValue::number() const {
  require_kind(json_->is_number() && std::isfinite(json_->get<double>()), "a finite number");
  return json_->get<double>();
}

double JsonValue::positive() const {
  require_kind(json_->is_number() && number() > 0, "a number > 0");
  return number();
}

int JsonValue::whole(int lowest, int highest) const {
  const bool is =
      json_->is_number() && number() == std::floor(number()) && number() >= lowest && number() <= highest;
  require_kind(is,
               ("a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest)).c_str());
  return json_->get<int>();
}

std::string JsonValue::text() const {
  require_kind(json_->is_string(), "a text");
  return json_->get<std::string>();
}

bool JsonValue::truth() const {
  require_kind(json_->is_boolean(), "true or false");
  return json_->get<bool>();
}

std::vector<JsonValue> JsonValue::items() const {
  require_kind(json_->is_array(), "a list [...]");
  std::vector<JsonValue> values;
  for (std::size_t i = 0; i < json_->size(); ++i)
    values.emplace_back((*json_)[i], std::string(path_).append("[").append(std::to_string(i)).append("]"));
  return values;
}

std::vector<double> JsonValue::numbers() const {
  std::vector<double> values;
  for (const JsonValue& item : items()) values.push_back(item.number());
  return values;
}

std::vector<int> JsonValue::whole_numbers() const {
  std::vector<int> values;
  for (const JsonValue& item : items()) values.push_back(item.whole(0, 2'147'483'647));
  return values;
}

Eigen::Vector3d JsonValue::point(int dim) const {
  const std::vector<double> values = numbers();
  if (static_cast<int>(values.size()) != dim)
    fail("must be " + std::to_string(dim) + " numbers, not " + std::to_string(values.size()));
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::copy(values.begin(), values.end(), point.data());
  return point;
}

void JsonValue::require_one_of(const std::vector<std::string>& names) const {
  if (std::find(names.begin(), names.end(), text()) == names.end())
    fail("unknown '" + text() + "'; there are " + listed(names));
}

}  // namespace isostretch::app

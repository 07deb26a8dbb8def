#pragma once

#include "common/output_folder.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isostretch::app {

// Throws Error naming file, line and column. // and /* */ comments are allowed.
Json read_json_file(const std::filesystem::path& file);
/// Parses text as read_json_file() does; `name` stands for the file in messages.
Json parse_json(const std::string& text, const std::string& name);

// A value inside a JSON document that knows its path, "handles[1].rotate.axis", and names it in every
// message. The document must live longer.
class JsonValue {
 public:
  explicit JsonValue(const Json& json, std::string path = {}) : json_(&json), path_(std::move(path)) {}

  const Json& json() const { return *json_; }
  const std::string& path() const { return path_; }
  [[noreturn]] void fail(const std::string& what) const;

  // Of objects. only() throws Error naming a key that is none of these.
  const JsonValue& only(const std::vector<std::string>& keys) const;
  bool has(const std::string& key) const;
  JsonValue at(const std::string& key) const;
  std::optional<JsonValue> find(const std::string& key) const;

  bool is_text() const { return json_->is_string(); }
  bool is_object() const { return json_->is_object(); }

  double number() const;  // finite
  double positive() const;
  int whole(int lowest, int highest) const;
  std::string text() const;
  bool truth() const;
  std::vector<JsonValue> items() const;  // of an array
  std::vector<double> numbers() const;
  std::vector<int> whole_numbers() const;
  Eigen::Vector3d point(int dim) const;  // dim numbers; in 2D the last is zero

  template <class Choice, std::size_t N>
  Choice choice(const ChoiceNames<Choice, N>& names) const {
    require_one_of(all_names(names));
    return choice_of(names, text());
  }
  void require_one_of(const std::vector<std::string>& names) const;

 private:
  void require_kind(bool is, const char* kind) const;

  const Json* json_;
  std::string path_;
};

// Errors of libraries that know no path get it here.
template <class Work>
auto naming(const JsonValue& value, Work&& work) {
  try {
    return work();
  } catch (const Error& error) {
    value.fail(error.what());
  }
}

}  // namespace isostretch::app

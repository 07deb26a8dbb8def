#include "json.hpp"

#include <isostretch/comparison/program_run.hpp>
#include <isostretch/core/text.hpp>

#include <cmath>
#include <limits>

namespace isostretch::comparison {
namespace {

Json value_of(const Record& record, const char* key) {
  const Json& json = json_of(record);
  return json.is_object() ? json.value(key, Json()) : Json();
}

}  // namespace

const Json& json_of(const Record& record) {
  static const Json null;
  return record.content() != nullptr ? record.content()->json : null;
}

std::string file_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

double number(const Json& object, const char* key) {
  if (!object.is_object() || !object.contains(key) || !object.at(key).is_number())
    return std::numeric_limits<double>::quiet_NaN();
  return object.at(key).get<double>();
}

std::string number_text(const Json& value, const char* pattern) {
  return value.is_number() ? formatted(pattern, value.get<double>()) : std::string("–");
}

std::string number_text(double value, const char* pattern) {
  return std::isfinite(value) ? formatted(pattern, value) : "–";
}

Record Record::parse(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Record() : record_of(std::move(json));
}

Record Record::of_file(const std::filesystem::path& file) {
  return std::filesystem::exists(file) ? parse(text_of(file)) : Record();
}

bool Record::is_object() const {
  return json_of(*this).is_object();
}

double Record::number(const char* key) const {
  return comparison::number(json_of(*this), key);
}

std::string Record::text(const char* key) const {
  const Json value = value_of(*this, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

bool Record::truth(const char* key) const {
  const Json value = value_of(*this, key);
  return value.is_boolean() && value.get<bool>();
}

Record Record::at(const char* key) const {
  return record_of(value_of(*this, key));
}

std::string Record::to_json(int indent) const {
  return json_of(*this).dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace isostretch::comparison

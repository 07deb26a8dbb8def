// Records as the library's sources see them. The JSON library stays within them.
#pragma once

#include <isostretch/comparison/record.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <utility>

namespace isostretch::comparison {

using Json = nlohmann::ordered_json;

struct Record::Content {
  Json json;
};

const Json& json_of(const Record& record);

inline Record record_of(Json json) {
  return Record(std::make_shared<const Record::Content>(Record::Content{std::move(json)}));
}

// Of a file that somebody opens: two blanks a level, and a line break at the end.
std::string file_text(const Json& json);

// NaN where there is no such number.
double number(const Json& object, const char* key);

// As the pattern says; a dash where it is no number.
std::string number_text(const Json& value, const char* pattern);
std::string number_text(double value, const char* pattern);

}  // namespace isostretch::comparison

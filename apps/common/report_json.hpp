#pragma once

#include <isostretch/reports/json_text.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

// What libraries report as text, as the JSON that apps compose summaries of.
namespace isostretch::app {

using Json = nlohmann::ordered_json;

inline Json solve_json(const newton::Summary& summary) {
  return Json::parse(reports::solve_json(summary));
}

inline Json phases_json(const newton::Seconds& seconds) {
  return Json::parse(reports::phases_json(seconds));
}

inline Json misses_json(const std::vector<deformation::HandleMiss>& misses) {
  return Json::parse(reports::misses_json(misses));
}

inline std::string handle_table(const Json& handles, const Json& misses) {
  return reports::handle_table(handles.dump(), misses.dump());
}

}  // namespace isostretch::app

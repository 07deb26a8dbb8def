#include <isostretch/reports/json_text.hpp>

#include "handle_misses.hpp"

namespace isostretch::reports {
namespace {

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string solve_json(const newton::Summary& summary) {
  return line_of(json_of(summary));
}

std::string phases_json(const newton::Seconds& seconds) {
  return line_of(json_of(seconds));
}

std::string misses_json(const std::vector<deformation::HandleMiss>& misses) {
  return line_of(json_of(misses));
}

std::string handle_table(const std::string& handles, const std::string& misses) {
  return handle_table(Json::parse(handles), Json::parse(misses));
}

}  // namespace isostretch::reports

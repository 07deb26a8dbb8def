#include "json.hpp"

#include <isostretch/comparison/method_summary.hpp>
#include <isostretch/reports/json_text.hpp>

namespace isostretch::comparison {

std::string method_summary(const Problem& problem, const std::string& method, const newton::Summary& summary,
                           const Vector& x, const Record& machine) {
  Json json{{"problem", problem.name}, {"method", method}};
  json.update(Json::parse(reports::solve_json(summary)));
  json.update({{"failed", newton::failed(summary.status)},
               {"seconds", Json::parse(reports::phases_json(summary.seconds))},
               {"flips", problem.flips(x)},
               {"facts", json_of(problem.facts)},
               {"machine", json_of(machine)}});
  return file_text(json);
}

}  // namespace isostretch::comparison

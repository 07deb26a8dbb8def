#include "handle_misses.hpp"

#include <isostretch/figures/html.hpp>

#include <algorithm>

namespace isostretch::reports {

namespace html = figures::html;
using deformation::HandleMiss;

Json json_of(const std::vector<HandleMiss>& misses) {
  Json json = Json::array();
  for (const HandleMiss& miss : misses)
    json.push_back({{"name", miss.name},
                    {"mean", miss.mean},
                    {"largest", miss.largest},
                    {"share_of_size", miss.size > 0 ? Json(miss.share()) : Json()},
                    {"size", miss.size},
                    {"size_reached", miss.size_reached},
                    {"farthest_node", miss.farthest_node}});
  return json;
}

std::string handle_table(const Json& handles, const Json& misses) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& handle : handles) {
    rows.push_back({handle["name"], handle["kind"], number(handle.value("weight", Json()), "%.4g"),
                    number(handle["nodes"], "%.0f")});
    const auto miss = std::find_if(misses.begin(), misses.end(),
                                   [&](const Json& m) { return m["name"] == handle["name"]; });
    for (const char* key : {"size", "size_reached", "mean", "largest"})
      rows.back().push_back(miss != misses.end() ? number((*miss)[key], "%.3g") : "–");
    rows.back().push_back(miss != misses.end() ? number((*miss)["share_of_size"], "%.3f") : "–");
  }
  return html::block("div",
                     html::table({{"handle"},
                                  {"kind"},
                                  {"weight", true},
                                  {"nodes", true},
                                  {"size wanted", true},
                                  {"size reached", true},
                                  {"mean miss", true},
                                  {"largest miss", true},
                                  {"share of its size", true}},
                                 rows),
                     "class=\"wide\"");
}

}  // namespace isostretch::reports

#include "common/handle_miss_report.hpp"
#include "common/html.hpp"
#include "common/report_style.hpp"
#include "report.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/deformation/handle_misses.hpp>

namespace isostretch::app::deform {
namespace {

using app::number;

std::string frame_table(const Json& frames) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& f : frames)
    rows.push_back({std::to_string(f["frame"].get<int>()), number(f["time"], "%.4g"), in_words(f["status"]),
                    std::to_string(f["iterations"].get<int>()), std::to_string(f["parts"].get<int>()),
                    number(f.value("energy", Json()), "%.8g"),
                    number(f.value("gradient_inf_norm", Json()), "%.1e"), number(f["min_det_F"], "%.3g"),
                    number(f["max_length_change"], "%.3g"), std::to_string(f["inverted"].get<int>()),
                    number(f.value("seconds", Json()), "%.2f")});
  const std::vector<html::Column> columns{
      {"frame", true},      {"time", true},      {"status"},
      {"iterations", true}, {"parts", true},     {"energy", true},
      {"|gradient|", true}, {"min det F", true}, {"change of length", true},
      {"inverted", true},   {"seconds", true}};
  return html::block("div", html::table(columns, rows), "class=\"wide\"");
}

std::string region_table(const Json& regions) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& r : regions) {
    std::string parameters;
    for (const auto& [name, value] : r["energy_parameters"].items())
      parameters += (parameters.empty() ? "" : ", ") + name + " = " + number(value, "%.6g");
    rows.push_back({r["name"], r["energy_name"], parameters, std::to_string(r["elements"].get<int>())});
  }
  return html::table({{"region"}, {"energy"}, {"parameters"}, {"elements", true}}, rows);
}

}  // namespace

std::string report_page(const Result& r, const Json& summary, const std::string& picture,
                        const std::string& preview) {
  const bool good = exit_code(r) == ExitCode::success;
  std::string body = html::block("h1", html::escaped(r.body.name));
  body += html::block("p", html::escaped(html::sentence(verdict(r))),
                      good ? "class=\"verdict\"" : "class=\"verdict bad\"");
  body += html::warnings(r.warnings);
  body += html::figure(picture, "The body at rest and in the last frame",
                       "At rest and in the last frame. Pale where lengths are kept, dark where the worst "
                       "direction is stretched or shrunk most; lines: where handles end; arrows: where they "
                       "go; rings: targets of soft ones.");
  body += preview;
  body += html::block("h2", "Handles, last frame") +
          handle_table(summary.at("handles"), summary.at("frames").back().at("handles"));
  body += html::block("h2", "Regions") + region_table(summary.at("regions"));
  body += html::block("h2", "Frames") + frame_table(summary.at("frames"));
  body += html::block("footer", "isostretch-deform " + summary.at("version").get<std::string>());
  return html::page(r.body.name + ", deformed", report_style, body);
}

}  // namespace isostretch::app::deform

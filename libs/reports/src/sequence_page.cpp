#include "sequence_record.hpp"

#include "handle_misses.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/report_style.hpp>

namespace isostretch::reports {
namespace {

namespace html = figures::html;

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

std::string SequenceReport::summary_text(const RunFacts& facts) const {
  return file_text(record_->summary(verdict(), facts));
}

std::string SequenceReport::page(const RunFacts& facts, const std::string& picture,
                                 const std::string& preview) const {
  const Json summary = record_->summary(verdict(), facts);
  const std::string& name = record_->input.body.name;
  const bool good = status() == RunStatus::success;
  std::string body = html::block("h1", html::escaped(name));
  body += html::block("p", html::escaped(html::sentence(verdict())),
                      good ? "class=\"verdict\"" : "class=\"verdict bad\"");
  body += html::warnings(record_->warnings);
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
  return html::page(name + ", deformed", html::report_style, body);
}

}  // namespace isostretch::reports

#include "interpolation_record.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/report_style.hpp>

namespace isostretch::reports {
namespace {

namespace html = figures::html;

std::string frame_table(const Json& frames) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& f : frames)
    rows.push_back({number(f["frame"], "%.0f"), number(f["time"], "%.4g"),
                    f["converged"].get<bool>() ? "yes" : "no", number(f["iterations"], "%.0f"),
                    number(f.value("energy", Json()), "%.7g"), number(f["min_det_F_1"], "%.3g"),
                    number(f["min_det_F_2"], "%.3g"), number(f["max_length_change_1"], "%.3g"),
                    number(f["inverted"], "%.0f"), number(f.value("seconds", Json()), "%.2f")});
  const std::vector<html::Column> columns{{"frame", true},       {"time", true},
                                          {"converged"},         {"iterations", true},
                                          {"energy", true},      {"min det F, first pose", true},
                                          {"second pose", true}, {"change of length", true},
                                          {"inverted", true},    {"seconds", true}};
  return html::block("div", html::table(columns, rows), "class=\"wide\"");
}

std::string fact_table(const Json& summary) {
  std::string parameters;
  for (const auto& [name, value] : summary.at("energy_parameters").items())
    parameters += (parameters.empty() ? "" : ", ") + name + " = " + number(value, "%.6g");
  const Json& mesh = summary.at("mesh");
  return html::table(
      {}, {{"elements", number(mesh.at("elements"), "%.0f") + " " + mesh.at("element").get<std::string>()},
           {"energy", summary.at("energy_name")},
           {"parameters", parameters.empty() ? "none" : parameters},
           {"start of every frame", summary.at("initial_guess")},
           {"iterations in all", number(summary.at("iterations"), "%.0f")},
           {"seconds in all", number(summary.at("seconds").at("total"), "%.2f")}});
}

}  // namespace

std::string InterpolationReport::summary_text(const RunFacts& facts) const {
  return file_text(record_->summary(verdict(), facts));
}

std::string InterpolationReport::page(const RunFacts& facts, const std::string& frames_png,
                                      const std::string& energies_png, const std::string& preview) const {
  const Json summary = record_->summary(verdict(), facts);
  const deformation::KeyShapes& shapes = record_->input.key_shapes;
  const std::string name = shapes.first.name + " to " + shapes.second.name;
  std::string body = html::block("h1", html::escaped(name));
  body += html::block("p", html::escaped(html::sentence(verdict())),
                      status() == RunStatus::success ? "class=\"verdict\"" : "class=\"verdict bad\"");
  body += html::warnings(record_->warnings);
  body += html::figure(
      frames_png, "Frames side by side",
      "From the first pose to the second. Pale where lengths are those of the first pose, dark where the "
      "worst direction is stretched or shrunk most.");
  body += preview;
  body += html::figure(energies_png, "The energy of every frame against both poses",
                       "How much each frame is distorted against either pose.");
  body += html::block("h2", "Frames") + frame_table(summary.at("frames"));
  body += html::block("h2", "Problem") + fact_table(summary);
  body += html::block("footer", "isostretch-interpolate " + summary.at("version").get<std::string>());
  return html::page(name + ", interpolated", html::report_style, body);
}

}  // namespace isostretch::reports

#include "manipulation_summary.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/report_style.hpp>
#include <isostretch/reports/json_text.hpp>

namespace isostretch::comparison {

namespace html = figures::html;

namespace {

std::string cell(const Json& frame, const char* key, const char* pattern) {
  return frame.contains(key) ? number_text(frame[key], pattern) : "–";
}

std::string frame_table(const Json& frames) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& f : frames)
    rows.push_back({cell(f, "frame", "%.0f"), cell(f, "time", "%.4g"), in_words(f["status"]),
                    cell(f, "iterations", "%.0f"), cell(f, "linear_solves", "%.0f"),
                    cell(f, "elastic_energy", "%.7g"), cell(f, "target_energy", "%.5g"),
                    cell(f, "gap", "%.1e"), cell(f, "inverted_before", "%.0f"), cell(f, "inverted", "%.0f"),
                    cell(f, "min_det_F", "%.2g"), cell(f, "min_eigenvalue", "%.2g"),
                    cell(f, "seconds", "%.2f")});
  const std::vector<html::Column> columns{
      {"frame", true},     {"time", true},      {"status"},       {"iterations", true},      {"solves", true},
      {"E elastic", true}, {"E targets", true}, {"gap", true},    {"inverted before", true}, {"after", true},
      {"min det F", true}, {"min eig S", true}, {"seconds", true}};
  return html::block("div", html::table(columns, rows), "class=\"wide\"");
}

std::string fact_table(const ManipulationReport& r, const Json& summary) {
  const Json& totals = summary.at("totals");
  return html::table(
      {}, {{"method", summary.at("method")},
           {"alpha", number_text(r.scene.alpha, "%.6g")},
           {"element weights", name_of(choice_names(r.scene.weights), r.scene.weights)},
           {"lengths",
            r.scene.units == deformation::LengthUnit::diagonal ? "shares of the diagonal" : "of the mesh"},
           {"incompressibility", number_text(r.scene.incompressibility, "%.6g")},
           {"margin", number_text(r.scene.margin, "%.6g")},
           {"factorizations in all", number_text(totals.at("linear_solves"), "%.0f")},
           {"seconds for the handles' weights", number_text(summary.at("seconds").at("weights"), "%.2f")},
           {"seconds in all", number_text(summary.at("seconds").at("total"), "%.2f")}});
}

std::string pictures(const std::string& states, const std::string& path) {
  if (states.empty()) return {};
  return html::figure(
             states, "The body at rest, by the unconstrained minimiser, and the result",
             "At rest, by the unconstrained minimiser (without constraints), and the result. Pale where "
             "lengths "
             "are kept, dark where the worst direction is stretched or shrunk most; inverted elements "
             "are blue; lines: where handles end; arrows: where they go; rings: their "
             "targets.") +
         html::figure(path, "The iterates of the last frame and how they converge",
                      "The way there: iterates of the last frame, and over the seconds how many elements are "
                      "inverted and how much lower the energy could be at most.");
}

}  // namespace

std::string report_page(const ManipulationReport& r, const ManipulationSeconds& seconds,
                        const std::string& states, const std::string& path, const std::string& preview) {
  const Json summary = summary_json(r, seconds, 1);
  const bool good = r.status() == reports::RunStatus::success;
  std::string body = html::block("h1", html::escaped(r.name));
  body += html::block("p", html::escaped(html::sentence(r.verdict())),
                      good ? "class=\"verdict\"" : "class=\"verdict bad\"");
  body += html::warnings(r.warnings) + pictures(states, path) + preview;
  body += html::block("h2", "Frames") + frame_table(summary.at("frames"));
  if (r.last.positions.size() > 0)
    body += html::block("h2", formatted("Handles, frame %d", r.last.frame)) +
            reports::handle_table(summary.at("handles").dump(), reports::misses_json(r.misses(r.last)));
  body += html::block("h2", "Problem") + fact_table(r, summary);
  body += html::block("footer", "isostretch-manipulate " + summary.at("version").get<std::string>());
  return html::page(r.name + ", manipulated", html::report_style, body);
}

}  // namespace isostretch::comparison

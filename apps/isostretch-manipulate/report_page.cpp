#include "common/handle_miss_report.hpp"
#include "common/html.hpp"
#include "common/report_style.hpp"
#include "report.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/deformation/handle_misses.hpp>

namespace isostretch::app::manipulate {
namespace {

using app::number;

std::string number(const Json& frame, const char* key, const char* pattern) {
  return frame.contains(key) ? number(frame[key], pattern) : "–";
}

std::string frame_table(const Json& frames) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& f : frames)
    rows.push_back({number(f, "frame", "%.0f"), number(f, "time", "%.4g"), in_words(f["status"]),
                    number(f, "iterations", "%.0f"), number(f, "linear_solves", "%.0f"),
                    number(f, "elastic_energy", "%.7g"), number(f, "target_energy", "%.5g"),
                    number(f, "gap", "%.1e"), number(f, "inverted_before", "%.0f"),
                    number(f, "inverted", "%.0f"), number(f, "min_det_F", "%.2g"),
                    number(f, "min_eigenvalue", "%.2g"), number(f, "seconds", "%.2f")});
  const std::vector<html::Column> columns{
      {"frame", true},     {"time", true},      {"status"},       {"iterations", true},      {"solves", true},
      {"E elastic", true}, {"E targets", true}, {"gap", true},    {"inverted before", true}, {"after", true},
      {"min det F", true}, {"min eig S", true}, {"seconds", true}};
  return html::block("div", html::table(columns, rows), "class=\"wide\"");
}

// As the last frame that was made has them.
std::string handles_section(const Result& r, const Json& summary) {
  const Json misses =
      misses_json(deformation::handle_misses(r.handle_set, r.last.time, r.body.dim, r.last.positions));
  return html::block("h2", formatted("Handles, frame %d", r.last.frame)) +
         handle_table(summary.at("handles"), misses);
}

std::string fact_table(const Result& r, const Json& summary) {
  const Json& totals = summary.at("totals");
  return html::table(
      {}, {{"method", summary.at("method")},
           {"alpha", number(r.scene.alpha, "%.6g")},
           {"element weights", name_of(choice_names(r.scene.weights), r.scene.weights)},
           {"lengths",
            r.scene.units == deformation::LengthUnit::diagonal ? "shares of the diagonal" : "of the mesh"},
           {"incompressibility", number(r.scene.incompressibility, "%.6g")},
           {"margin", number(r.scene.margin, "%.6g")},
           {"factorizations in all", number(totals.at("linear_solves"), "%.0f")},
           {"seconds for the handles' weights", number(summary.at("seconds").at("weights"), "%.2f")},
           {"seconds in all", number(summary.at("seconds").at("total"), "%.2f")}});
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

std::string report_page(const Result& r, const Json& summary, const std::string& states,
                        const std::string& path, const std::string& preview) {
  const bool good = exit_code(r) == ExitCode::success;
  std::string body = html::block("h1", html::escaped(r.name));
  body += html::block("p", html::escaped(html::sentence(verdict(r))),
                      good ? "class=\"verdict\"" : "class=\"verdict bad\"");
  body += html::warnings(r.warnings) + pictures(states, path) + preview;
  body += html::block("h2", "Frames") + frame_table(summary.at("frames"));
  if (r.last.positions.size() > 0) body += handles_section(r, summary);
  body += html::block("h2", "Problem") + fact_table(r, summary);
  body += html::block("footer", "isostretch-manipulate " + summary.at("version").get<std::string>());
  return html::page(r.name + ", manipulated", report_style, body);
}

}  // namespace isostretch::app::manipulate

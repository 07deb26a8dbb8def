#include "parameterization_summary.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/parameterization_figures.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace isostretch::reports {
namespace {

namespace html = figures::html;

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t most_charts = 50, most_pins = 10;

std::string real(const Json& value, int digits) {
  return value.is_number() ? formatted("%.*g", digits, value.get<double>()) : "–";  // null: not finite
}

std::string count(const Json& value) {
  return value.is_number() ? with_thousands(value.get<long long>()) : "–";
}

std::string section(const std::string& title, const Rows& rows) {
  return html::block("section", html::element("h3", title) + "\n" + html::table({{""}, {"", true}}, rows));
}

std::string model_facts(const Json& mesh, const Json& repairs) {
  Rows rows = {
      {"vertices", count(mesh.at("vertices"))},     {"triangles", count(mesh.at("triangles"))},
      {"components", count(mesh.at("components"))}, {"boundary loops", count(mesh.at("boundary_loops"))},
      {"genus", count(mesh.at("genus"))},           {"area", real(mesh.at("area"), 6)}};
  // Lists of elements, of which the page has the number.
  for (const auto& [what, elements] : repairs.items())
    if (!elements.empty())
      rows.push_back(
          {"repaired: " + in_words(what), with_thousands(static_cast<long long>(elements.size()))});
  return section("Model", rows);
}

std::string layout_facts(const Json& layout) {
  Rows rows = {{"charts", count(layout.at("charts"))},
               {"uv points", count(layout.at("uv_points"))},
               {"edges cut", count(layout.at("cut_edges"))},
               {"length of the cuts", real(layout.at("cut_length"), 4)}};
  if (layout.at("further_cuts") > 0)
    rows.push_back({"cuts for the distortion", count(layout["further_cuts"])});
  rows.push_back({"uv per length", real(layout.at("uv_per_length"), 6)});
  if (layout.at("packed").get<bool>())
    rows.push_back({"square covered", formatted("%.1f %%", 100 * layout.at("coverage").get<double>())});
  const Json& overlap = layout.at("overlap");
  rows.push_back({"under more than one triangle", figures::share_text(overlap.at("share"))});
  if (overlap.at("triangles") > 0) rows.push_back({"triangles that overlap", count(overlap["triangles"])});
  if (overlap.contains("split") && overlap["split"]["charts_added"] > 0) {
    rows.push_back(
        {"the same before charts were split", figures::share_text(overlap["split"]["share_before"])});
    rows.push_back({"charts added by that", count(overlap["split"]["charts_added"])});
    rows.push_back({"length of cuts added", real(overlap["split"]["cut_length"], 4)});
  }
  return section("Layout", rows);
}

std::string solve_facts(const Json& s) {
  return section("Solve", {{"energy", s.at("energy_name").get<std::string>()},
                           {"at the start", real(s.at("initial_energy"), 6)},
                           {"in the end", real(s.at("energy"), 10)},
                           {"largest gradient entry", real(s.at("gradient_inf_norm"), 3)},
                           {"iterations", count(s.at("iterations"))},
                           {"factorizations", count(s.at("factorizations"))},
                           {"status", in_words(s.at("status").get<std::string>())},
                           {"linear solver", s.at("solver").get<std::string>()}});
}

std::string distortion_facts(const Json& s) {
  const Json& d = s.at("distortion");
  return section("Distortion", {{"smallest stretch", real(d.at("min_sigma"), 4)},
                                {"mean stretch", real(d.at("mean_sigma"), 4)},
                                {"largest stretch", real(d.at("max_sigma"), 4)},
                                {"mean area ratio", real(d.at("mean_area_ratio"), 4)},
                                {"mean angle distortion", real(d.at("mean_sigma_ratio"), 4)},
                                {"largest angle distortion", real(d.at("max_sigma_ratio"), 4)},
                                {"flipped triangles", count(s.at("flipped"))}});
}

std::string time_facts(const Json& s) {
  Rows rows;
  for (const auto& [phase, seconds] : s.at("seconds").items())
    rows.push_back({in_words(phase), real(seconds, 3)});
  rows.push_back({"threads", count(s.at("threads"))});
  return section("Seconds", rows);
}

Json entry(const Json& object, const char* key) {
  return object.contains(key) ? object[key] : Json();
}

std::vector<std::string> chart_row(const Json& chart, std::size_t number) {
  const double area = chart.at("area");
  const Json energy = entry(chart, "energy"), status = entry(chart, "status");
  return {std::to_string(number),
          count(chart.at("triangles")),
          formatted("%.2f %%", 100 * area),
          energy.is_number() ? formatted("%.6g", energy.get<double>() / area) : "–",
          count(entry(chart, "iterations")),
          status.is_string() ? in_words(status.get<std::string>()) : "–",
          in_words(chart.at("start").get<std::string>())};
}

std::string pin_text(const Json& pin) {
  std::string text =
      pin.at("kind").get<std::string>() + " at vertex " + std::to_string(pin.at("vertex").get<int>());
  if (pin.contains("uv")) text += ": " + real(pin["uv"].at(0), 6) + ", " + real(pin["uv"].at(1), 6);
  if (pin.contains("weight")) text += ", weight " + real(pin["weight"], 6);
  return text;
}

std::string pins_text(const Json& pins) {
  std::string text;
  for (std::size_t i = 0; i < std::min(pins.size(), most_pins); ++i)
    text += (i ? "; " : "") + pin_text(pins[i]);
  if (pins.size() > most_pins) text += formatted("; and %zu more", pins.size() - most_pins);
  return text.empty() ? "none" : text;
}

std::string option_text(const std::string& name, const Json& value) {
  if (name == "pins") return pins_text(value);
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return real(value, 6);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::string fact_tables(const Json& s) {
  return html::block("div",
                     model_facts(s.at("mesh"), s.at("repairs")) + layout_facts(s.at("layout")) +
                         distortion_facts(s) + solve_facts(s) + time_facts(s),
                     "class=\"facts\"");
}

std::string chart_table(const Json& charts) {
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return charts[a].at("area").get<double>() > charts[b].at("area").get<double>();
  });
  Rows rows;
  for (std::size_t i = 0; i < std::min(order.size(), most_charts); ++i)
    rows.push_back(chart_row(charts[order[i]], order[i]));
  std::string table = html::table({{"chart", true},
                                   {"triangles", true},
                                   {"area", true},
                                   {"energy per area", true},
                                   {"iterations", true},
                                   {"status"},
                                   {"start"}},
                                  rows);
  if (order.size() > most_charts)
    table += html::block("p", formatted("and %zu more", order.size() - most_charts));
  return html::block("div", table, "class=\"wide\"");
}

std::string option_table(const Json& s) {
  Rows rows = {{"model", s.at("mesh").at("file").get<std::string>()},
               {"energy", s.at("energy_name").get<std::string>()}};
  for (const auto& [name, value] : s.at("energy_parameters").items())
    rows.push_back({"energy: " + name, real(value, 6)});
  for (const auto& [name, value] : s.at("options").items())
    rows.push_back({in_words(name), option_text(name, value)});
  return html::table({{""}, {""}}, rows);
}

}  // namespace isostretch::reports

#include "comparison.hpp"

#include "common/html.hpp"
#include "common/report_style.hpp"
#include "common/threads.hpp"

#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/figures/comparison_plot.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isostretch::app::manipulate {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double number(const Json& object, const char* key) {
  if (!object.is_object() || !object.contains(key) || !object.at(key).is_number()) return unknown;
  return object.at(key).get<double>();
}

double phase(const Candidate& c, const char* name) {
  return c.frame.is_object() && c.frame.contains("solver_seconds") ? number(c.frame["solver_seconds"], name)
                                                                   : unknown;
}

double error_of(const Comparison& comparison, const Candidate& c) {
  return c.is_convex() && c.has_positions() ? relative_error(comparison, number(c.frame, "energy")) : unknown;
}

// Of its process, or of the program that this one ran.
double own_peak(const Candidate& c) {
  const double peak = std::max(c.peak_megabytes, std::max(0.0, number(c.frame, "peak_megabytes")));
  return peak > 0 ? peak : unknown;
}

// A column of the tables: its name, how a page shows it, and the number.
struct Quantity {
  const char* name;
  const char* pattern;
  double (*of)(const Comparison&, const Candidate&);
};

const std::vector<Quantity>& quantities() {
  using C = const Comparison&;
  using S = const Candidate&;
  static const std::vector<Quantity> all{
      {"iterations", "%.0f", [](C, S s) { return number(s.frame, "iterations"); }},
      {"linear_solves", "%.0f",
       [](C, S s) {
         const double count = number(s.frame, "linear_solves");
         return count >= 0 ? count : unknown;
       }},
      {"modelling_seconds", "%.3f", [](C, S s) { return phase(s, "modelling"); }},
      {"solving_seconds", "%.3f", [](C, S s) { return phase(s, "solving"); }},
      {"reading_seconds", "%.3f", [](C, S s) { return phase(s, "reading"); }},
      {"seconds", "%.3f", [](C, S s) { return s.seconds; }},
      {"relative_error", "%.1e", error_of},
      {"min_eigenvalue", "%.1e", [](C, S s) { return number(s.frame, "min_eigenvalue"); }},
      {"not_psd", "%.0f", [](C, S s) { return number(s.frame, "not_psd"); }},
      {"inverted", "%.0f", [](C, S s) { return number(s.frame, "inverted"); }},
      {"min_det_F", "%.1e", [](C, S s) { return number(s.frame, "min_det_F"); }},
      {"energy", "%.8g", [](C, S s) { return number(s.frame, "energy"); }},
      {"distortion", "%.6g", [](C, S s) { return number(s.frame, "distortion"); }},
      {"target_energy", "%.4g", [](C, S s) { return number(s.frame, "target_energy"); }},
      {"peak_megabytes", "%.0f", [](C, S s) { return own_peak(s); }}};
  return all;
}

const char* kind_name(const Candidate& c) {
  return c.is_convex() ? "convex" : "alternative";
}

using figures::ComparisonPanel;
using figures::Point;

// One panel: `value` of every row of the traces against seconds or iterations.
template <class Value>
ComparisonPanel panel(const Comparison& comparison, std::string title, bool against_seconds, bool logarithmic,
                      const Value& value) {
  ComparisonPanel result{std::move(title), against_seconds ? "seconds" : "iterations", true, logarithmic, {}};
  for (const Candidate& c : comparison.candidates) {
    auto& curve = result.curves.emplace_back();
    for (const TraceRow& row : c.trace)
      curve.push_back({against_seconds ? row.seconds : std::max(0.5, double(row.iteration)), value(c, row)});
  }
  return result;
}

std::string known(double value, const char* pattern) {
  return std::isfinite(value) ? formatted(pattern, value) : "unknown";
}

std::string cell(const Quantity& quantity, const Comparison& comparison, const Candidate& c) {
  const double value = quantity.of(comparison, c);
  return std::isfinite(value) ? formatted(quantity.pattern, value) : "–";
}

}  // namespace

double relative_error(const Comparison& comparison, double energy) {
  // At rest the optimum is 0 but for rounding: energies are sums of squares of numbers around 1.
  const double rounding = 1e-15 * comparison.mesh.at("elements").get<double>();
  return std::abs(energy - comparison.optimum) / std::max(std::abs(comparison.optimum), rounding);
}

std::string comparison_table(const Comparison& comparison) {
  std::string text = "solver,kind,status";
  for (const Quantity& quantity : quantities()) text.append(1, ',').append(quantity.name);
  text += '\n';
  for (const Candidate& c : comparison.candidates) {
    text.append(c.info.name).append(1, ',').append(kind_name(c)).append(1, ',').append(c.status);
    for (const Quantity& quantity : quantities()) {
      const double value = quantity.of(comparison, c);
      text.append(1, ',').append(std::isfinite(value) ? to_text(value) : "");
    }
    text += '\n';
  }
  return text;
}

Json comparison_json(const Comparison& comparison) {
  Json solvers = Json::array();
  for (const Candidate& c : comparison.candidates) {
    Json json{{"solver", c.info.name},
              {"title", c.info.title},
              {"source", c.info.source},
              {"kind", kind_name(c)},
              {"status", c.status},
              {"message", c.message},
              {"least_seconds", c.least_seconds},
              {"most_seconds", c.most_seconds}};
    for (const Quantity& quantity : quantities()) json[quantity.name] = quantity.of(comparison, c);
    solvers.push_back(std::move(json));
  }
  return {{"name", comparison.name},
          {"mesh", comparison.mesh},
          {"optimum", comparison.optimum},
          {"lower_bound", comparison.lower_bound},
          {"repetitions", comparison.repetitions},
          {"time_limit", comparison.time_limit},
          {"memory_limit", comparison.memory_limit},
          {"threads", thread_count()},
          {"version", version_string},
          {"solvers", solvers}};
}

std::string draw_comparison(const Comparison& comparison) {
  std::vector<std::string> names;
  for (const Candidate& c : comparison.candidates)
    names.push_back(std::string(c.info.name) + (c.trace.empty() ? " (" + c.status + ")" : ""));
  std::vector<ComparisonPanel> panels;
  for (const bool against_seconds : {true, false}) {
    panels.push_back(panel(comparison, "Relative error of the energy", against_seconds, true,
                           [&](const Candidate& c, const TraceRow& row) {
                             return c.is_convex() ? relative_error(comparison, row.energy) : unknown;
                           }));
    panels.push_back(panel(comparison, "How far the worst eigenvalue of S is below 0", against_seconds, true,
                           [](const Candidate& c, const TraceRow& row) {
                             return c.is_convex() ? std::max(0.0, -row.min_eigenvalue) : unknown;
                           }));
    panels.push_back(panel(comparison, "Inverted elements", against_seconds, false,
                           [](const Candidate&, const TraceRow& row) { return double(row.inverted); }));
  }
  return figures::draw_comparison(comparison.name + ": solvers of the inversion-free problem",
                                  with_thousands(comparison.mesh.at("elements").get<int>()) +
                                      " elements   ·   optimum " + known(comparison.optimum, "%.9g") +
                                      "   ·   rings: where a solver ended",
                                  names, panels, 3);
}

std::string comparison_page(const Comparison& comparison, const std::string& plots) {
  std::vector<html::Column> columns{{"solver"}, {"kind"}, {"status"}};
  for (const Quantity& quantity : quantities()) {
    columns.push_back({in_words(quantity.name), true});
  }
  std::vector<std::vector<std::string>> rows, notes;
  for (const Candidate& c : comparison.candidates) {
    rows.push_back({std::string(c.info.name), kind_name(c), in_words(c.status)});
    for (const Quantity& quantity : quantities()) rows.back().push_back(cell(quantity, comparison, c));
    notes.push_back(
        {std::string(c.info.name), std::string(c.info.title), std::string(c.info.source), c.message});
  }
  std::string body = html::block("h1", html::escaped(comparison.name + ": solvers compared"));
  body += html::block(
      "p", html::escaped("Optimum of the convex problem: " + known(comparison.optimum, "%.12g") +
                         ", at least " + known(comparison.lower_bound, "%.12g") +
                         formatted(". Each solver alone in its own process, %d time(s); seconds without "
                                   "measuring the iterates.",
                                   comparison.repetitions)));
  body += html::figure(plots, "Error, worst eigenvalue and inverted elements of every solver",
                       "Against seconds (above) and iterations (below). Solvers that show no iterates have "
                       "only their end.");
  body += html::block("h2", "Results") + html::block("div", html::table(columns, rows), "class=\"wide\"");
  body += html::block("h2", "Solvers") +
          html::block("div", html::table({{"solver"}, {"title"}, {"source"}, {"what it said"}}, notes),
                      "class=\"wide\"");
  body += html::block("footer", "isostretch-manipulate " + std::string(version_string));
  return html::page(comparison.name + ", solvers compared", report_style, body);
}

}  // namespace isostretch::app::manipulate

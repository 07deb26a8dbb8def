#include "json.hpp"

#include <isostretch/comparison/solver_comparison.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/numbers.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/figures/comparison_plot.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/report_style.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace isostretch::comparison {

namespace html = figures::html;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
// A gap that counts as an optimum.
constexpr double loose_gap = 1e-8;

double phase(const SolverCandidate& c, const char* name) {
  return c.frame.at("solver_seconds").number(name);
}

double error_of(const SolverComparison& comparison, const SolverCandidate& c) {
  return c.is_convex() && c.has_positions() ? relative_error(comparison, c.frame.number("energy")) : unknown;
}

// Of its process, or of the program that this one ran.
double own_peak(const SolverCandidate& c) {
  const double peak = std::max(c.peak_megabytes, std::max(0.0, c.frame.number("peak_megabytes")));
  return peak > 0 ? peak : unknown;
}

// A column of the tables: its name, how a page shows it, and the number.
struct Quantity {
  const char* name;
  const char* pattern;
  double (*of)(const SolverComparison&, const SolverCandidate&);
};

const std::vector<Quantity>& quantities() {
  using C = const SolverComparison&;
  using S = const SolverCandidate&;
  static const std::vector<Quantity> all{
      {"iterations", "%.0f", [](C, S s) { return s.frame.number("iterations"); }},
      {"linear_solves", "%.0f",
       [](C, S s) {
         const double count = s.frame.number("linear_solves");
         return count >= 0 ? count : unknown;
       }},
      {"modelling_seconds", "%.3f", [](C, S s) { return phase(s, "modelling"); }},
      {"solving_seconds", "%.3f", [](C, S s) { return phase(s, "solving"); }},
      {"reading_seconds", "%.3f", [](C, S s) { return phase(s, "reading"); }},
      {"seconds", "%.3f", [](C, S s) { return s.seconds; }},
      {"relative_error", "%.1e", error_of},
      {"min_eigenvalue", "%.1e", [](C, S s) { return s.frame.number("min_eigenvalue"); }},
      {"not_psd", "%.0f", [](C, S s) { return s.frame.number("not_psd"); }},
      {"inverted", "%.0f", [](C, S s) { return s.frame.number("inverted"); }},
      {"min_det_F", "%.1e", [](C, S s) { return s.frame.number("min_det_F"); }},
      {"energy", "%.8g", [](C, S s) { return s.frame.number("energy"); }},
      {"distortion", "%.6g", [](C, S s) { return s.frame.number("distortion"); }},
      {"target_energy", "%.4g", [](C, S s) { return s.frame.number("target_energy"); }},
      {"peak_megabytes", "%.0f", [](C, S s) { return own_peak(s); }}};
  return all;
}

const char* kind_name(const SolverCandidate& c) {
  return c.is_convex() ? "convex" : "alternative";
}

using figures::ComparisonPanel;
using figures::Point;

// One panel: `value` of every row of the traces against seconds or iterations.
template <class Value>
ComparisonPanel panel(const SolverComparison& comparison, std::string title, bool against_seconds,
                      bool logarithmic, const Value& value) {
  ComparisonPanel result{std::move(title), against_seconds ? "seconds" : "iterations", true, logarithmic, {}};
  for (const SolverCandidate& c : comparison.candidates) {
    auto& curve = result.curves.emplace_back();
    for (const SolverTraceRow& row : c.trace)
      curve.push_back({against_seconds ? row.seconds : std::max(0.5, double(row.iteration)), value(c, row)});
  }
  return result;
}

std::string known(double value, const char* pattern) {
  return std::isfinite(value) ? formatted(pattern, value) : "unknown";
}

std::string cell(const Quantity& quantity, const SolverComparison& comparison, const SolverCandidate& c) {
  const double value = quantity.of(comparison, c);
  return std::isfinite(value) ? formatted(quantity.pattern, value) : "–";
}

}  // namespace

double relative_error(const SolverComparison& comparison, double energy) {
  // At rest the optimum is 0 but for rounding: energies are sums of squares of numbers around 1.
  const double rounding = 1e-15 * comparison.mesh.elements;
  return std::abs(energy - comparison.optimum) / std::max(std::abs(comparison.optimum), rounding);
}

std::vector<baselines::SolverInfo> choose_solvers(const std::string& names) {
  const std::vector<baselines::SolverInfo> all = baselines::solvers();
  std::vector<baselines::SolverInfo> chosen;
  const auto has = [&](std::string_view name) {
    return std::any_of(chosen.begin(), chosen.end(), [&](const auto& c) { return c.name == name; });
  };
  for (const std::string& word : split(names, ',')) {
    const std::size_t before = chosen.size();
    for (const baselines::SolverInfo& info : all)
      if (word == "all" || word == info.name ||
          word == (info.kind == baselines::Kind::convex ? "convex" : "alternative"))
        if (!has(info.name)) chosen.push_back(info);
    if (chosen.size() > before || has(word)) continue;
    std::string known_names;
    for (const baselines::SolverInfo& info : all) known_names.append(", ").append(info.name);
    throw Error("there is no solver '" + word + "'; there are all, convex, alternative" + known_names);
  }
  return chosen;
}

SolverCandidate median_candidate(std::vector<SolverCandidate> repetitions) {
  const auto count = [&](const std::string& status) {
    return std::count_if(repetitions.begin(), repetitions.end(),
                         [&](const SolverCandidate& c) { return c.status == status; });
  };
  std::string best = repetitions.front().status;
  for (const SolverCandidate& c : repetitions)
    if (count(c.status) > count(best)) best = c.status;
  std::erase_if(repetitions, [&](const SolverCandidate& c) { return c.status != best; });
  std::sort(repetitions.begin(), repetitions.end(),
            [](const SolverCandidate& x, const SolverCandidate& y) { return x.seconds < y.seconds; });
  const double least = repetitions.front().seconds, most = repetitions.back().seconds;
  SolverCandidate median = std::move(repetitions[(repetitions.size() - 1) / 2]);
  median.least_seconds = least;
  median.most_seconds = most;
  return median;
}

std::string take_optimum(SolverComparison& comparison, const SolverCandidate& run, double gap) {
  if (!run.has_positions() || run.frame.number("not_psd") != 0 || std::isnan(run.frame.number("lower_bound")))
    return "the optimum is not known (" + run.status + ": " + run.message + "), nor are errors";
  SolverComparison found = comparison;
  found.lower_bound = run.frame.number("lower_bound");
  found.optimum = run.frame.number("energy");
  const double share = relative_error(found, found.lower_bound);
  if (!(share <= std::max(gap, loose_gap)))
    return formatted("the optimum is not known, but to a share of %.1e (", share) + run.message +
           "), nor are errors";
  comparison = std::move(found);
  if (share <= loose_gap) return {};
  return formatted("the optimum is known to a share of %.1e only (", share) + run.message + ")";
}

std::string outcome_text(const SolverComparison& comparison, const SolverCandidate& c) {
  std::string text = std::string(c.info.name) + ": " + c.status + formatted(", %.3g s", c.seconds);
  if (c.has_positions()) {
    if (c.is_convex() && std::isfinite(comparison.optimum))
      text += formatted(", error %.1e", relative_error(comparison, c.frame.number("energy")));
    text += formatted(", least eigenvalue %.1e, inverted %d", c.frame.number("min_eigenvalue"),
                      static_cast<int>(c.frame.number("inverted")));
  } else if (!c.message.empty()) {
    text += ": " + c.message;
  }
  return text;
}

std::string solver_table(const SolverComparison& comparison) {
  std::string text = "solver,kind,status";
  for (const Quantity& quantity : quantities()) text.append(1, ',').append(quantity.name);
  text += '\n';
  for (const SolverCandidate& c : comparison.candidates) {
    text.append(c.info.name).append(1, ',').append(kind_name(c)).append(1, ',').append(c.status);
    for (const Quantity& quantity : quantities()) {
      const double value = quantity.of(comparison, c);
      text.append(1, ',').append(std::isfinite(value) ? to_text(value) : "");
    }
    text += '\n';
  }
  return text;
}

std::string comparison_json(const SolverComparison& comparison) {
  Json solvers = Json::array();
  for (const SolverCandidate& c : comparison.candidates) {
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
  const ComparedMesh& mesh = comparison.mesh;
  const Json json{{"name", comparison.name},
                  {"mesh",
                   {{"name", mesh.name},
                    {"nodes", mesh.nodes},
                    {"elements", mesh.elements},
                    {"fingerprint", mesh.fingerprint}}},
                  {"optimum", comparison.optimum},
                  {"lower_bound", comparison.lower_bound},
                  {"repetitions", comparison.repetitions},
                  {"time_limit", comparison.time_limit},
                  {"memory_limit", comparison.memory_limit},
                  {"threads", comparison.threads},
                  {"version", version_string},
                  {"solvers", solvers}};
  return file_text(json);
}

std::string draw_comparison(const SolverComparison& comparison) {
  std::vector<std::string> names;
  for (const SolverCandidate& c : comparison.candidates)
    names.push_back(std::string(c.info.name) + (c.trace.empty() ? " (" + c.status + ")" : ""));
  std::vector<ComparisonPanel> panels;
  for (const bool against_seconds : {true, false}) {
    panels.push_back(panel(comparison, "Relative error of the energy", against_seconds, true,
                           [&](const SolverCandidate& c, const SolverTraceRow& row) {
                             return c.is_convex() ? relative_error(comparison, row.energy) : unknown;
                           }));
    panels.push_back(panel(comparison, "How far the worst eigenvalue of S is below 0", against_seconds, true,
                           [](const SolverCandidate& c, const SolverTraceRow& row) {
                             return c.is_convex() ? std::max(0.0, -row.min_eigenvalue) : unknown;
                           }));
    panels.push_back(
        panel(comparison, "Inverted elements", against_seconds, false,
              [](const SolverCandidate&, const SolverTraceRow& row) { return double(row.inverted); }));
  }
  return figures::draw_comparison(comparison.name + ": solvers of the inversion-free problem",
                                  with_thousands(comparison.mesh.elements) + " elements   ·   optimum " +
                                      known(comparison.optimum, "%.9g") +
                                      "   ·   rings: where a solver ended",
                                  names, panels, 3);
}

std::string comparison_page(const SolverComparison& comparison, const std::string& plots) {
  std::vector<html::Column> columns{{"solver"}, {"kind"}, {"status"}};
  for (const Quantity& quantity : quantities()) {
    columns.push_back({in_words(quantity.name), true});
  }
  std::vector<std::vector<std::string>> rows, notes;
  for (const SolverCandidate& c : comparison.candidates) {
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
  return html::page(comparison.name + ", solvers compared", html::report_style, body);
}

}  // namespace isostretch::comparison

#include "json.hpp"

#include <isostretch/comparison/method_page.hpp>
#include <isostretch/comparison/method_verdicts.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/report_style.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::comparison {

namespace html = figures::html;

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string wide_table(const std::vector<html::Column>& columns, const Rows& rows) {
  return html::block("div", html::table(columns, rows), "class=\"wide\"");
}

std::string heading(const char* level, const std::string& text) {
  return html::block(level, html::escaped(text));
}

std::string paragraph(const std::string& text) {
  return html::block("p", html::escaped(text));
}

std::string list(const std::vector<std::string>& lines) {
  std::string items;
  for (const std::string& line : lines) items += html::element("li", html::escaped(line)) + "\n";
  return lines.empty() ? std::string() : html::block("ul", items);
}

std::string goal_column(const Goal& goal) {
  return goal.error ? goal.name() : "gradient";
}

// ---- of all problems ----

std::string machine_table(const MethodComparison& comparison) {
  const Json& m = json_of(comparison.machine);
  const ComparisonSettings& settings = comparison.settings;
  std::string environment;
  for (const auto& [name, value] : m.at("environment").items())
    environment += (environment.empty() ? "" : ", ") + name + "=" + value.get<std::string>();
  return html::table(
      {{}, {}},
      {{"date", comparison.date},
       {"processor", m.at("processor").get<std::string>() + ", " + number_text(m.at("cores"), "%.0f") +
                         " cores, " + number_text(m.at("memory_megabytes").get<double>() / 1024, "%.0f GB")},
       {"system", m.at("system")},
       {"threads", number_text(m.at("threads"), "%.0f") + (environment.empty() ? "" : "; " + environment)},
       {"program", "isostretch-compare " + m.at("version").get<std::string>() + ", instruction set " +
                       m.at("instruction_set").get<std::string>()},
       {"compiler and flags", m.at("compiler").get<std::string>() + "; " + m.at("flags").get<std::string>()},
       {"every run",
        formatted("until |gradient|_inf <= %g, %d iterations", settings.limits.gradient_tolerance,
                  settings.limits.max_iterations) +
            (settings.limits.time_limit > 0 ? formatted(" or %g s", settings.limits.time_limit) : "") +
            formatted(", in a process of its own; %d repetition(s)", settings.repetitions)}});
}

std::string benchmark_cell(const GoalBenchmark& benchmark) {
  if (benchmark.first.empty()) return "nobody";
  if (benchmark.default_is_first())
    return "first; best rival " + number_text(benchmark.rival_factor(), "%.2f");
  return benchmark.first + "; " + number_text(benchmark.factor(), "%.2f");
}

// A row a problem: who is first.
std::string overview(const MethodComparison& comparison) {
  std::vector<html::Column> columns{{"problem"}, {"energy"}, {"elements", true}, {"optimum", true}};
  for (const Goal& goal : chief_goals(comparison.settings.limits)) columns.push_back({goal_column(goal)});
  Rows rows;
  for (const ComparedProblem& problem : comparison.problems) {
    rows.push_back({problem.name, problem.facts.text("energy"),
                    with_thousands(json_of(problem.facts).at("elements").get<int>()),
                    number_text(problem.optimum, "%.10g")});
    for (const Goal& goal : chief_goals(comparison.settings.limits))
      rows.back().push_back(benchmark_cell(benchmark_goal(goal, problem, comparison.settings.limits)));
  }
  return paragraph("Where " + default_method() +
                   " is first: how many times as long the best rival takes. Elsewhere: who is first, and how "
                   "many times as long " +
                   default_method() + " takes (–: it does not get there).") +
         wide_table(columns, rows);
}

// ---- of one problem ----

// The median, and after # the repetition that has it.
std::string median_cell(const Spread& spread) {
  return std::isfinite(spread.median) ? formatted("%.3g #%d", spread.median, spread.repetition) : "–";
}

std::string range_cell(const Spread& spread) {
  if (!std::isfinite(spread.least)) return "–";
  return formatted("%.3g to ", spread.least) +
         (std::isfinite(spread.most) ? formatted("%.3g", spread.most) : "∞");
}

// Of no method of ours, over the default.
std::vector<std::string> rival_row(const ComparedProblem& problem, const scene::ComparisonLimits& limits) {
  std::vector<std::string> row{"best rival over " + default_method()};
  for (const Goal& goal : all_goals(limits)) {
    const GoalBenchmark result = benchmark_goal(goal, problem, limits);
    row.push_back(number_text(result.rival_factor(), "%.2f ") + result.best_rival);
  }
  return row;
}

template <class Cell>
Rows goal_rows(const ComparedProblem& problem, const scene::ComparisonLimits& limits, const Cell& cell) {
  Rows rows;
  for (const MethodCandidate& candidate : problem.candidates) {
    if (candidate.runs.empty()) continue;
    rows.push_back({std::string(candidate.info.name)});
    for (const Goal& goal : all_goals(limits))
      rows.back().push_back(cell(time_to(goal, problem, candidate, limits)));
  }
  return rows;
}

std::string goal_table(const scene::ComparisonLimits& limits, const Rows& rows) {
  std::vector<html::Column> columns{{"method"}};
  for (const Goal& goal : all_goals(limits)) columns.push_back({goal_column(goal), true});
  return wide_table(columns, rows);
}

std::string time_tables(const ComparedProblem& problem, const scene::ComparisonLimits& limits,
                        int repetitions) {
  Rows medians = goal_rows(problem, limits, median_cell);
  medians.push_back(rival_row(problem, limits));
  std::string text =
      heading("h3", "Seconds until the relative error stays at or below") + goal_table(limits, medians) +
      paragraph("Medians over the repetitions; #2 is the repetition that has it, in runs/" + problem.name +
                "/<method>/2/trace.csv. The last column: until |gradient|_inf "
                "stays at or below the tolerance.");
  if (repetitions == 1) return text;
  return text + heading("h3", "The same from the least to the most of the repetitions") +
         goal_table(limits, goal_rows(problem, limits, range_cell));
}

Json of_summary(const MethodRun* run, const char* key) {
  return run != nullptr && run->has_summary() ? json_of(run->summary).at(key) : Json();
}

std::string effort_table(const ComparedProblem& problem) {
  const std::vector<html::Column> columns{{"method"},
                                          {"status"},
                                          {"iterations", true},
                                          {"factorizations", true},
                                          {"seconds", true},
                                          {"least to most", true},
                                          {"relative error", true},
                                          {"flips", true},
                                          {"peak MB", true}};
  Rows rows;
  for (const MethodCandidate& candidate : problem.candidates) {
    const MethodRun* run = candidate.typical();
    if (run == nullptr) continue;
    const Spread seconds = total_seconds(candidate);
    rows.push_back({std::string(candidate.info.name), in_words(run->status),
                    number_text(of_summary(run, "iterations"), "%.0f"),
                    number_text(of_summary(run, "factorizations"), "%.0f"), median_cell(seconds),
                    range_cell(seconds), number_text(problem.relative_error(run->energy()), "%.1e"),
                    number_text(of_summary(run, "flips"), "%.0f"),
                    number_text(peak_megabytes(candidate).median, "%.0f")});
  }
  return wide_table(columns, rows);
}

std::string phase_table(const ComparedProblem& problem) {
  Rows rows;
  for (const MethodCandidate& candidate : problem.candidates) {
    const IterationPhases t = milliseconds_per_iteration(candidate);
    if (std::isnan(t.total)) continue;
    rows.push_back({std::string(candidate.info.name)});
    for (const double value : {t.total, t.assembly, t.factorization, t.solve, t.line_search, t.other})
      rows.back().push_back(number_text(value, "%.3g"));
  }
  return wide_table({{"method"},
                     {"all", true},
                     {"assembly", true},
                     {"factorization", true},
                     {"solve", true},
                     {"line search", true},
                     {"set-up and other", true}},
                    rows);
}

std::string failures(const ComparedProblem& problem) {
  Rows rows;
  for (const MethodCandidate& candidate : problem.candidates)
    if (!candidate.why_not_applicable.empty())
      rows.push_back(
          {std::string(candidate.info.name), "not run: not applicable", candidate.why_not_applicable});
  for (const Shortfall& shortfall : shortfalls(problem))
    rows.push_back({shortfall.method, in_words(shortfall.status), shortfall.message});
  if (rows.empty()) return paragraph("Every method converged.");
  return wide_table({{"method"}, {"status"}, {"reason"}}, rows);
}

std::string problem_facts(const ComparedProblem& problem) {
  const Json& f = json_of(problem.facts);
  std::string parameters;
  for (const auto& [name, value] : f.at("parameters").items())
    parameters += ", " + name + " = " + number_text(value, "%.6g");
  return paragraph(
      f.at("mesh").get<std::string>() + " (" + f.at("kind").get<std::string>() + "), " +
      with_thousands(f.at("elements").get<int>()) + " elements, " + with_thousands(f.at("nodes").get<int>()) +
      " nodes, " + with_thousands(f.at("pinned").get<int>()) + " of them held; energy " +
      f.at("energy").get<std::string>() + parameters +
      formatted(", %.8g at the start. ", f.at("start_energy").get<double>()) +
      formatted("Optimum E* = %.15g", problem.optimum) +
      (problem.optimum_of.empty() ? ""
                                  : ", by " + problem.optimum_of + " (" + problem.optimum_folder + ").") +
      " Errors are (E - E*) / |E*|.");
}

std::string problem_section(const ComparedProblem& problem, const ComparisonSettings& settings,
                            const std::string& figure) {
  const scene::ComparisonLimits& limits = settings.limits;
  std::string text = heading("h2", problem.name) + problem_facts(problem);
  text += list(verdicts(problem, limits));
  const auto doubts = reservations(problem, limits);
  for (const std::string& doubt : doubts)
    text += html::block("p", html::escaped(doubt + "."), "class=\"verdict bad\"");
  text += figure;
  text += time_tables(problem, settings.limits, settings.repetitions);
  text += heading("h3", "MethodRuns to their end") + effort_table(problem);
  text += heading("h3", "Milliseconds per iteration") + phase_table(problem);
  text += heading("h3", "Not run, or not converged") + failures(problem);
  return text;
}

std::string method_list(const MethodComparison& comparison) {
  Rows rows;
  for (const MethodCandidate& candidate : comparison.problems.front().candidates)
    rows.push_back({std::string(candidate.info.name), std::string(candidate.info.title),
                    std::string(baselines::family_name(candidate.info.family)),
                    std::string(candidate.info.source)});
  return html::table({{"method"}, {"title"}, {"family"}, {"source"}}, rows);
}

std::string figure_of(const std::vector<NamedPicture>& pictures, std::size_t i,
                      const std::string& description, const std::string& caption) {
  return i < pictures.size() ? html::figure(pictures[i].png, description, caption) : std::string();
}

}  // namespace

std::string comparison_page(const MethodComparison& comparison, const std::vector<NamedPicture>& pictures) {
  const std::size_t count = comparison.problems.size();
  std::string body = heading("h1", "How far from the optimum each method is after how long");
  body += overview(comparison) + machine_table(comparison);
  if (count > 1)
    body += heading("h2", "Performance profiles") +
            figure_of(pictures, count, "Performance profiles",
                      "Share of the problems that a method solves within a factor of the first (Dolan and "
                      "More 2002). A method that was not run on a problem does not solve it.");
  for (std::size_t p = 0; p < count; ++p) {
    const ComparedProblem& problem = comparison.problems[p];
    body += problem_section(
        problem, comparison.settings,
        figure_of(pictures, p, "Error and gradient of every method, " + problem.name,
                  "Of every method the repetition with the median of the seconds. The dashed line is the "
                  "gradient tolerance."));
  }
  body += heading("h2", "Methods") + method_list(comparison);
  body += html::block("footer", "isostretch-compare " + std::string(version_string));
  return html::page("isostretch-compare", html::report_style, body);
}

}  // namespace isostretch::comparison

#include "json.hpp"

#include <isostretch/comparison/method_tables.hpp>
#include <isostretch/core/to_text.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::comparison {
namespace {

using Cells = std::vector<std::pair<std::string, Json>>;  // name of the column, and value

Json known(const Record& record, const char* key) {
  const Json& summary = json_of(record);
  return summary.is_object() && summary.contains(key) ? summary.at(key) : Json();
}

// Infinite and unknown numbers are null in JSON.
Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

// "seconds" makes seconds_median, seconds_least, seconds_most and seconds_repetition.
void add_spread(const std::string& name, const Spread& spread, Cells& cells) {
  cells.emplace_back(name + "_median", finite(spread.median));
  cells.emplace_back(name + "_least", finite(spread.least));
  cells.emplace_back(name + "_most", finite(spread.most));
  cells.emplace_back(name + "_repetition", spread.repetition > 0 ? Json(spread.repetition) : Json());
}

std::string column_of(const Goal& goal) {
  return goal.error ? "seconds_to_" + goal.name() : "seconds_to_gradient_tolerance";
}

Cells run_cells(const ComparedProblem& problem, const MethodCandidate& candidate, const MethodRun& run,
                const scene::ComparisonLimits& limits) {
  Cells cells{{"problem", problem.name},
              {"method", candidate.info.name},
              {"repetition", run.repetition},
              {"status", run.status},
              {"converged", run.converged},
              {"iterations", known(run.summary, "iterations")},
              {"factorizations", known(run.summary, "factorizations")},
              {"seconds", finite(run.seconds)},
              {"energy", finite(run.energy())},
              {"relative_error", finite(problem.relative_error(run.energy()))},
              {"gradient_inf_norm", known(run.summary, "gradient_inf_norm")},
              {"flips", known(run.summary, "flips")},
              {"peak_megabytes", run.peak_megabytes}};
  for (const Goal& goal : all_goals(limits))
    cells.emplace_back(column_of(goal), finite(seconds_to(goal, problem, run, limits)));
  cells.emplace_back("folder", run.folder);
  cells.emplace_back("message", run.message);
  return cells;
}

void add_phases(const IterationPhases& times, Cells& cells) {
  for (const auto& [name, value] : {std::pair("assembly", times.assembly),
                                    {"factorization", times.factorization},
                                    {"solve", times.solve},
                                    {"line_search", times.line_search},
                                    {"other", times.other},
                                    {"total", times.total}})
    cells.emplace_back(std::string("ms_per_iteration_") + name, finite(value));
}

Cells method_cells(const ComparedProblem& problem, const MethodCandidate& candidate,
                   const scene::ComparisonLimits& limits) {
  const MethodRun* run = candidate.typical();
  const Record summary = run != nullptr ? run->summary : Record();
  const double energy = run != nullptr ? run->energy() : unknown;
  Cells cells{{"problem", problem.name},
              {"method", candidate.info.name},
              {"family", baselines::family_name(candidate.info.family)},
              {"status", candidate.why_not_applicable.empty() ? candidate.status() : "not_applicable"},
              {"iterations", known(summary, "iterations")},
              {"factorizations", known(summary, "factorizations")},
              {"energy", finite(energy)},
              {"relative_error", finite(problem.relative_error(energy))},
              {"flips", known(summary, "flips")}};
  add_spread("seconds", total_seconds(candidate), cells);
  add_phases(milliseconds_per_iteration(candidate), cells);
  for (const Goal& goal : all_goals(limits))
    add_spread(column_of(goal), time_to(goal, problem, candidate, limits), cells);
  add_spread("peak_megabytes", peak_megabytes(candidate), cells);
  cells.emplace_back("message", !candidate.why_not_applicable.empty() ? candidate.why_not_applicable
                                : run != nullptr                      ? run->message
                                                                      : "");
  return cells;
}

Json as_object(const Cells& cells) {
  Json object = Json::object();
  for (const auto& [name, value] : cells) object[name] = value;
  return object;
}

// Texts in quotes where they need them.
std::string csv_cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number_float()) return to_text(value.get<double>());
  if (!value.is_string()) return value.dump();
  std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

std::string csv_table(const std::vector<Cells>& rows) {
  std::string text;
  const auto add_line = [&](const Cells& cells, const auto& cell) {
    for (std::size_t i = 0; i < cells.size(); ++i) text.append(i > 0 ? "," : "").append(cell(cells[i]));
    text += '\n';
  };
  if (!rows.empty()) add_line(rows.front(), [](const auto& candidate) { return candidate.first; });
  for (const Cells& cells : rows)
    add_line(cells, [](const auto& candidate) { return csv_cell(candidate.second); });
  return text;
}

Json benchmark_json(const GoalBenchmark& benchmark) {
  return {{"goal", benchmark.goal.name()},
          {"first", benchmark.first},
          {"first_seconds", finite(benchmark.first_seconds)},
          {"default_is_first", benchmark.default_is_first()},
          {"default_seconds", finite(benchmark.default_seconds)},
          {"best_rival", benchmark.best_rival},
          {"best_rival_seconds", finite(benchmark.rival_seconds)},
          {"best_rival_over_default", finite(benchmark.rival_factor())}};
}

Json method_json(const ComparedProblem& problem, const MethodCandidate& candidate,
                 const scene::ComparisonLimits& limits) {
  Json json = as_object(method_cells(problem, candidate, limits));
  json.erase("problem");
  json["title"] = candidate.info.title;
  json["source"] = candidate.info.source;
  json["runs"] = Json::array();
  for (const MethodRun& run : candidate.runs) {
    json["runs"].push_back(as_object(run_cells(problem, candidate, run, limits)));
    json["runs"].back()["seconds_by_phase"] = known(run.summary, "seconds");
  }
  return json;
}

Json problem_json(const ComparedProblem& problem, const scene::ComparisonLimits& limits) {
  Json json{{"name", problem.name},
            {"facts", json_of(problem.facts)},
            {"optimum", finite(problem.optimum)},
            {"optimum_of", problem.optimum_of},
            {"optimum_folder", problem.optimum_folder},
            {"optimum_polished", problem.polished},
            {"other_minima", Json::array()},
            {"benchmarks", Json::array()},
            {"methods", Json::array()}};
  for (const OtherMinimum& other : problem.elsewhere)
    json["other_minima"].push_back({{"method", other.method}, {"energy", other.energy}});
  for (const Goal& goal : chief_goals(limits))
    json["benchmarks"].push_back(benchmark_json(benchmark_goal(goal, problem, limits)));
  for (const MethodCandidate& candidate : problem.candidates)
    json["methods"].push_back(method_json(problem, candidate, limits));
  return json;
}

Json profile_json(const Profile& profile) {
  Json curves = Json::array();
  for (const Profile::Curve& curve : profile.curves) {
    Json factors = Json::array();
    for (const double factor : curve.factors) factors.push_back(finite(factor));
    curves.push_back({{"method", curve.method}, {"factors", factors}});
  }
  return {{"goal", profile.goal.name()}, {"methods", curves}};
}

}  // namespace

std::string run_table(const MethodComparison& comparison) {
  std::vector<Cells> rows;
  for (const ComparedProblem& problem : comparison.problems)
    for (const MethodCandidate& candidate : problem.candidates)
      for (const MethodRun& run : candidate.runs)
        rows.push_back(run_cells(problem, candidate, run, comparison.settings.limits));
  return csv_table(rows);
}

std::string method_table(const MethodComparison& comparison) {
  std::vector<Cells> rows;
  for (const ComparedProblem& problem : comparison.problems)
    for (const MethodCandidate& candidate : problem.candidates)
      rows.push_back(method_cells(problem, candidate, comparison.settings.limits));
  return csv_table(rows);
}

std::string comparison_json(const MethodComparison& comparison) {
  const scene::ComparisonLimits& limits = comparison.settings.limits;
  Json json{{"date", comparison.date},
            {"machine", json_of(comparison.machine)},
            {"default", default_method()},
            {"repetitions", comparison.settings.repetitions},
            {"gradient_tolerance", limits.gradient_tolerance},
            {"max_iterations", limits.max_iterations},
            {"time_limit", limits.time_limit},
            {"memory_limit", limits.memory_limit},
            {"problems", Json::array()}};
  for (const ComparedProblem& problem : comparison.problems)
    json["problems"].push_back(problem_json(problem, limits));
  if (comparison.problems.size() < 2) return file_text(json);
  json["profiles"] = Json::array();
  for (const Profile& profile : performance_profiles(comparison))
    json["profiles"].push_back(profile_json(profile));
  return file_text(json);
}

}  // namespace isostretch::comparison

#include "json.hpp"

#include <isostretch/comparison/method_plots.hpp>
#include <isostretch/comparison/method_verdicts.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/figures/comparison_plot.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isostretch::comparison {
namespace {

using figures::ComparisonPanel;
using figures::PictureFormat;
using figures::Point;

// Below this share of the optimum differences of energies are rounding.
constexpr double least_error = 1e-13;

// One panel: `value` of every row of the traces against seconds or iterations.
template <class Value>
ComparisonPanel panel(const ComparedProblem& problem, std::string title, bool against_seconds,
                      const Value& value) {
  ComparisonPanel result{std::move(title), against_seconds ? "seconds" : "iteration + 1", true, true, {}};
  for (const MethodCandidate& candidate : problem.candidates) {
    auto& curve = result.curves.emplace_back();
    const MethodRun* run = candidate.median_run();
    if (run == nullptr) continue;
    for (const MethodTraceRow& row : run->trace)
      curve.push_back({against_seconds ? row.seconds : row.iteration + 1, value(row)});
  }
  return result;
}

std::vector<ComparisonPanel> trace_panels(const ComparedProblem& problem,
                                          const scene::ComparisonLimits& limits) {
  std::vector<ComparisonPanel> panels;
  for (const bool against_seconds : {true, false}) {
    panels.push_back(panel(problem, "Relative error of the energy", against_seconds,
                           [&](const MethodTraceRow& row) { return problem.relative_error(row.energy); }));
    panels.back().lowest_y = least_error;
  }
  for (const bool against_seconds : {true, false}) {
    panels.push_back(panel(problem, "|gradient|∞", against_seconds,
                           [](const MethodTraceRow& row) { return row.gradient; }));
    if (limits.gradient_tolerance > 0) panels.back().levels = {limits.gradient_tolerance};
  }
  return panels;
}

// None for a method that has no curve; the others keep their colours.
std::string legend_name(const MethodCandidate& candidate) {
  std::string name(candidate.info.name);
  if (candidate.runs.empty()) return "";
  const MethodRun* run = candidate.median_run();
  return run != nullptr && run->converged ? name : name + " (" + candidate.status() + ")";
}

NamedPicture drawn(const std::string& file, const std::string& title, const std::string& subtitle,
                   const std::vector<std::string>& names, const std::vector<ComparisonPanel>& panels) {
  const auto draw = [&](PictureFormat format) {
    return figures::draw_comparison(title, subtitle, names, panels, 2, format);
  };
  return {file, draw(PictureFormat::png), draw(PictureFormat::svg)};
}

NamedPicture draw_problem(const ComparedProblem& problem, const scene::ComparisonLimits& limits) {
  std::vector<std::string> names;
  for (const MethodCandidate& candidate : problem.candidates) names.push_back(legend_name(candidate));
  const std::string subtitle =
      problem.facts.text("energy") + " on " +
      with_thousands(json_of(problem.facts).at("elements").get<int>()) +
      formatted(" elements   ·   optimum %.10g   ·   rings: where a method ended", problem.optimum);
  return drawn(problem.name, problem.name + ": how far from the optimum", subtitle, names,
               trace_panels(problem, limits));
}

// The share of problems that a method solves within a factor of the first, as stairs.
std::vector<Point> stairs(std::vector<double> factors, double largest) {
  const auto count = static_cast<double>(factors.size());
  std::erase_if(factors, [](double factor) { return !std::isfinite(factor); });
  std::sort(factors.begin(), factors.end());
  std::vector<Point> points;
  if (factors.empty()) return points;
  points.push_back({1, 0});
  for (std::size_t i = 0; i < factors.size(); ++i) {
    points.push_back({factors[i], static_cast<double>(i) / count});
    points.push_back({factors[i], static_cast<double>(i + 1) / count});
  }
  points.push_back({largest, points.back().y});
  return points;
}

double largest_factor(const std::vector<Profile>& profiles) {
  double largest = 2;
  for (const Profile& profile : profiles)
    for (const Profile::Curve& curve : profile.curves)
      for (const double factor : curve.factors)
        if (std::isfinite(factor)) largest = std::max(largest, factor);
  return largest;
}

NamedPicture draw_profiles(const MethodComparison& comparison) {
  const std::vector<Profile> profiles = performance_profiles(comparison);
  std::vector<ComparisonPanel> panels;
  for (const Profile& profile : profiles) {
    ComparisonPanel panel{"Share solved to " + goal_text(profile.goal, comparison.settings.limits),
                          "times as long as the first",
                          true,
                          false,
                          {}};
    panel.counts = false;
    for (const Profile::Curve& curve : profile.curves)
      panel.curves.push_back(stairs(curve.factors, largest_factor(profiles)));
    panels.push_back(std::move(panel));
  }
  return drawn("profiles", "Performance profiles",
               formatted("share of the %zu problems that a method solves within a factor of the first",
                         comparison.problems.size()),
               comparison.settings.methods, panels);
}

}  // namespace

std::vector<NamedPicture> draw_all(const MethodComparison& comparison) {
  std::vector<NamedPicture> pictures;
  for (const ComparedProblem& problem : comparison.problems)
    pictures.push_back(draw_problem(problem, comparison.settings.limits));
  if (comparison.problems.size() > 1) pictures.push_back(draw_profiles(comparison));
  return pictures;
}

}  // namespace isostretch::comparison

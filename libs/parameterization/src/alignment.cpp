#include "alignment.hpp"

#include "placement.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace isostretch::parameterization {
namespace {

const char* option_of(const Line& line) {
  return line.axis == 1 ? "horizontal" : "vertical";
}

// So that the first line already points along its axis, from its first vertex to its last.
void turn(Vector& x, const Line& line) {
  const Point2 from = x.segment<2>(2 * line.nodes.front()), to = x.segment<2>(2 * line.nodes.back());
  const Point2 along = to - from;
  if (!(along.norm() > 0)) return;
  const double angle = (line.axis == 1 ? 0.0 : std::acos(0.0)) - std::atan2(along.y(), along.x());
  const double c = std::cos(angle), s = std::sin(angle);
  for (Eigen::Index i = 0; i < x.size(); i += 2) {
    const double u = x[i], v = x[i + 1];
    x[i] = c * u - s * v;
    x[i + 1] = s * u + c * v;
  }
}

// The coordinate of the line: that of its vertices that stay where they are, or else the mean.
double level(const Vector& x, const Line& line, const std::vector<int>& kept) {
  std::optional<double> pinned;
  for (const int node : kept) {
    if (std::find(line.nodes.begin(), line.nodes.end(), node) == line.nodes.end()) continue;
    const double at = x[2 * node + line.axis];
    if (pinned && *pinned != at)
      throw OptionError(
          option_of(line),
          std::string("two of its vertices are pinned at different ") + (line.axis == 1 ? "v" : "u"),
          ErrorKind::input);
    pinned = at;
  }
  if (pinned) return *pinned;
  double sum = 0;
  for (const int node : line.nodes) sum += x[2 * node + line.axis];
  return sum / static_cast<double>(line.nodes.size());
}

std::vector<Target> on_lines(const Vector& x, const std::vector<Line>& lines, const std::vector<int>& kept) {
  Vector moved = x;
  for (const Line& line : lines) {
    const double at = level(moved, line, kept);
    for (const int node : line.nodes) moved[2 * node + line.axis] = at;
  }
  std::vector<Target> targets;
  for (const Line& line : lines)
    for (const int node : line.nodes) targets.push_back({node, moved.segment<2>(2 * node)});
  return targets;
}

// Lines along the same axis that share a vertex are one line.
void unite(Line line, std::vector<Line>& lines) {
  const auto touches = [&](const Line& other) {
    return other.axis == line.axis &&
           std::find_first_of(other.nodes.begin(), other.nodes.end(), line.nodes.begin(), line.nodes.end()) !=
               other.nodes.end();
  };
  for (auto other = std::find_if(lines.begin(), lines.end(), touches); other != lines.end();
       other = std::find_if(lines.begin(), lines.end(), touches)) {
    line.nodes.insert(line.nodes.end(), other->nodes.begin(), other->nodes.end());
    lines.erase(other);
  }
  lines.push_back(std::move(line));
}

}  // namespace

std::vector<Line> resolve_lines(const Domain& domain, const Start& start, const Options& options) {
  std::vector<Line> lines;
  for (const AlignedVertices& wanted : options.aligned) {
    Line line{{}, wanted.horizontal ? 1 : 0};
    for (const int vertex : wanted.vertices)
      line.nodes.push_back(open_vertex(domain, vertex, option_of(line)));
    const auto on_one_chart = std::any_of(start.charts.begin(), start.charts.end(), [&](const Chart& chart) {
      return lines_of_chart({line}, chart).size() == 1;
    });
    if (!on_one_chart)
      throw OptionError(option_of(line), "vertex " + std::to_string(wanted.vertices.front()) +
                                             " and the others are not all in one chart");
    unite(std::move(line), lines);
  }
  return lines;
}

std::vector<Line> lines_of_chart(const std::vector<Line>& lines, const Chart& chart) {
  std::vector<Line> own;
  for (const Line& line : lines) {
    Line renumbered{{}, line.axis};
    for (const int node : line.nodes) {
      const auto found = std::lower_bound(chart.open_vertex.begin(), chart.open_vertex.end(), node);
      if (found == chart.open_vertex.end() || *found != node) break;
      renumbered.nodes.push_back(static_cast<int>(found - chart.open_vertex.begin()));
    }
    if (renumbered.nodes.size() == line.nodes.size()) own.push_back(std::move(renumbered));
  }
  return own;
}

void place_lines(Vector& x, const std::vector<Line>& lines, const Pins& pins,
                 const assembly::Elements& elements, const energies::AnyEnergy& energy, const Chart& chart,
                 const Options& options) {
  if (lines.empty()) return;
  if (pins.hard.empty() && chart.held_boundary.empty()) turn(x, lines.front());
  Placement placement;
  placement.targets = [&](const Vector& at) { return on_lines(at, lines, placement.kept); };
  for (const HardPin& pin : pins.hard) placement.kept.push_back(pin.node);
  placement.kept.insert(placement.kept.end(), chart.held_boundary.begin(), chart.held_boundary.end());
  const int culprit = move_to(x, placement, elements, energy, chart, options);
  if (culprit >= 0)
    throw OptionError(
        option_of(lines.front()),
        "the vertices cannot come to lie on a line without turning over triangle " + std::to_string(culprit),
        ErrorKind::input);
}

void tie_lines(newton::Objective& objective, const std::vector<Line>& lines) {
  for (const Line& line : lines)
    for (const int node : line.nodes) objective.add_equality(line.nodes.front(), node, line.axis);
}

}  // namespace isostretch::parameterization

#include <isostretch/core/error.hpp>
#include <isostretch/parameterization/pins.hpp>

#include "placement.hpp"
#include "similarity.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace isostretch::parameterization {
namespace {

bool has_targets(const Pins& pins) {
  for (const HardPin& pin : pins.hard)
    if (pin.target) return true;
  return false;
}

bool at_targets(const Vector& x, const Pins& pins) {
  for (const HardPin& pin : pins.hard)
    if (pin.target && x.segment<2>(2 * pin.node) != *pin.target) return false;
  return true;
}

void align(Vector& x, const Pins& pins) {
  std::vector<Point2> from, to;
  for (const HardPin& pin : pins.hard)
    if (pin.target) {
      from.push_back(x.segment<2>(2 * pin.node));
      to.push_back(*pin.target);
    }
  const Similarity similarity = best_similarity(from, to);
  for (Eigen::Index i = 0; i < x.size(); i += 2) x.segment<2>(i) = similarity(x.segment<2>(i));
}

std::vector<Target> targets_of(const Pins& pins) {
  std::vector<Target> targets;
  for (const HardPin& pin : pins.hard)
    if (pin.target) targets.push_back({pin.node, *pin.target});
  return targets;
}

std::vector<int> kept_in_place(const Pins& pins) {
  std::vector<int> kept;
  for (const HardPin& pin : pins.hard)
    if (!pin.target) kept.push_back(pin.node);
  return kept;
}

}  // namespace

std::vector<int> Pins::nodes() const {
  std::vector<int> all;
  for (const HardPin& pin : hard) all.push_back(pin.node);
  for (const newton::SoftPin& pin : soft) all.push_back(pin.node);
  return all;
}

Pins Pins::of_chart(const Chart& chart) const {
  Pins own;
  if (hard.empty() && soft.empty()) return own;
  std::map<int, int> number;  // of a vertex of the opened mesh in the chart
  for (std::size_t v = 0; v < chart.open_vertex.size(); ++v)
    number[chart.open_vertex[v]] = static_cast<int>(v);
  const auto take = [&](const auto& pins, auto& into) {
    for (auto pin : pins)
      if (const auto found = number.find(pin.node); found != number.end()) {
        pin.node = found->second;
        into.push_back(pin);
      }
  };
  take(hard, own.hard);
  take(soft, own.soft);
  return own;
}

Pins resolve_pins(const Domain& domain, const Start& start, const Options& options) {
  Pins pins;
  std::set<int> hard;
  if (options.has_pins() && options.packs(start.charts.size()))
    throw OptionError("pin", "packing moves the " + std::to_string(start.charts.size()) +
                                 " chart(s) of the surface; pack none keeps them in place");
  for (const Pin& pin : options.pins) {
    HardPin resolved;
    resolved.node = open_vertex(domain, pin.vertex, "pin");
    if (pin.target) {
      resolved.target = *pin.target / start.unit_length;
      resolved.output = pin.target->transpose();
    }
    hard.insert(resolved.node);
    pins.hard.push_back(resolved);
  }
  for (const SoftPin& pin : options.soft_pins) {
    const int node = open_vertex(domain, pin.vertex, "soft-pin");
    if (hard.count(node) != 0)
      throw OptionError("soft-pin", "vertex " + std::to_string(pin.vertex) + " is pinned hard as well");
    const Point2 target = pin.target / start.unit_length;
    pins.soft.push_back({node, {target.x(), target.y()}, pin.weight});
  }
  return pins;
}

void require_free(const Pins& pins, const Chart& chart) {
  for (const HardPin& pin : pins.hard)
    if (pin.target && std::find(chart.held_boundary.begin(), chart.held_boundary.end(), pin.node) !=
                          chart.held_boundary.end())
      throw OptionError("pin", "a vertex with a target lies on the boundary that is held");
}

void place_hard_pins(Vector& x, const Pins& pins, const assembly::Elements& elements,
                     const energies::AnyEnergy& energy, const Chart& chart, const Options& options) {
  require_free(pins, chart);
  if (!has_targets(pins) || at_targets(x, pins)) return;
  std::vector<int> kept = kept_in_place(pins);
  kept.insert(kept.end(), chart.held_boundary.begin(), chart.held_boundary.end());
  if (kept.empty()) align(x, pins);
  const std::vector<Target> targets = targets_of(pins);
  const int culprit =
      move_to(x, {[&](const Vector&) { return targets; }, kept}, elements, energy, chart, options);
  if (culprit >= 0)
    throw OptionError("pin",
                      "the hard pins cannot be reached without turning over triangle " +
                          std::to_string(culprit) + "; move them or make them soft",
                      ErrorKind::input);
}

}  // namespace isostretch::parameterization

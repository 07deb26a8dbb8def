#include "placement.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/log.hpp>
#include <isostretch/newton/minimize.hpp>
#include <isostretch/surface/orientation.hpp>

namespace isostretch::parameterization {
namespace {

void snap(Vector& x, const Placement& placement) {
  for (const Target& target : placement.targets(x)) x.segment<2>(2 * target.node) = target.at;
}

// -1 and x moved onto the targets when that leaves no triangle turned over; otherwise one that it would turn
// over.
int snap_without_flips(Vector& x, const Placement& placement, const Chart& chart) {
  Vector trial = x;
  snap(trial, placement);
  const auto flipped = mesh::orientation(points(trial), chart.mesh.triangles).flipped;
  if (!flipped.empty()) return chart.triangle[static_cast<std::size_t>(flipped.front())];
  x = trial;
  return -1;
}

// A few iterations with the targets as soft pins of that weight.
void step_with_soft_targets(Vector& x, const Placement& placement, double weight,
                            const assembly::Elements& elements, const energies::AnyEnergy& energy,
                            newton::Options options) {
  newton::Objective objective(2, elements.node_count);
  objective.add<newton::EnergyTerm>(elements, energy);
  std::vector<newton::SoftPin> soft;
  for (const Target& target : placement.targets(x))
    soft.push_back({target.node, {target.at.x(), target.at.y()}, weight});
  objective.add<newton::SoftPinTerm>(2, elements.node_count, soft);
  for (const int node : placement.kept) objective.pin(node);
  options.max_iterations = 30;
  newton::minimize(objective, x, options);
}

}  // namespace

int move_to(Vector& x, const Placement& placement, const assembly::Elements& elements,
            const energies::AnyEnergy& energy, const Chart& chart, const Options& options) {
  if (!energy.has_barrier()) {
    snap(x, placement);
    return -1;
  }
  int culprit = snap_without_flips(x, placement, chart);
  if (culprit < 0) return -1;
  log(LogLevel::info,
      "pulling the layout towards its constraints first: moved there at once they turn triangles over");
  for (double weight = 1; weight <= 1e6 && !options.newton.stop.stop_requested(); weight *= 10) {
    step_with_soft_targets(x, placement, weight, elements, energy, options.newton);
    culprit = snap_without_flips(x, placement, chart);
    if (culprit < 0) return -1;
  }
  if (options.newton.stop.stop_requested())
    throw Error(ErrorKind::stopped, "interrupted before the layout met its constraints");
  return culprit;
}

Vector positions(const mesh::Points2& uv) {
  return Eigen::Map<const Vector>(uv.data(), uv.size());
}

mesh::Points2 points(const Vector& x) {
  return Eigen::Map<const mesh::Points2>(x.data(), x.size() / 2, 2);
}

}  // namespace isostretch::parameterization

#include <isostretch/core/error.hpp>
#include <isostretch/core/to_text.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace isostretch::sdp_penalty {
namespace {

void require(bool condition, const std::string& text) {
  if (!condition) throw Error("inversion-free problem: " + text);
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

// R^T R = I and det R = 1, to what a file of ten digits keeps.
bool is_rotation(const double* R, int dim) {
  constexpr double tolerance = 1e-8;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) {
      double dot = 0;
      for (int k = 0; k < dim; ++k) dot += R[k * dim + i] * R[k * dim + j];
      if (!(std::abs(dot - (i == j ? 1.0 : 0.0)) <= tolerance)) return false;
    }
  if (dim == 2) return R[0] * R[3] - R[1] * R[2] > 0;
  return R[0] * (R[4] * R[8] - R[5] * R[7]) - R[1] * (R[3] * R[8] - R[5] * R[6]) +
             R[2] * (R[3] * R[7] - R[4] * R[6]) >
         0;
}

void require_compatible_targets(const Problem& problem) {
  std::vector<int> held(static_cast<std::size_t>(problem.node_count()), -1);  // by which target
  for (std::size_t h = 0; h < problem.targets.size(); ++h) {
    const Target& target = problem.targets[h];
    if (!target.hard) continue;
    int& first = held[static_cast<std::size_t>(target.node)];
    require(first < 0 || problem.targets[static_cast<std::size_t>(first)].position == target.position,
            "targets " + std::to_string(first) + " and " + std::to_string(h) + " hold node " +
                std::to_string(target.node) + " in different places");
    first = static_cast<int>(h);
  }
}

// A component that nothing holds could be anywhere.
void require_held_components(const Problem& problem) {
  const std::vector<int> component = assembly::component_of_nodes(problem.elements);
  std::vector<bool> held(component.size(), false), held_component(component.size(), false);
  for (const Target& target : problem.targets) {
    if (!target.hard && problem.alpha == 0) continue;
    const auto node = static_cast<std::size_t>(target.node);
    held[node] = true;
    if (component[node] >= 0) held_component[static_cast<std::size_t>(component[node])] = true;
  }
  for (std::size_t node = 0; node < component.size(); ++node)
    require(component[node] < 0 ? held[node] : held_component[static_cast<std::size_t>(component[node])],
            "no target holds node " + std::to_string(node) +
                (component[node] < 0 ? ", which belongs to no element" : " or another of its component"));
}

}  // namespace

void Problem::validate() const {
  elements.validate();
  require(elements.points_per_element == 1, "elements must have one quadrature point");
  const std::size_t count = static_cast<std::size_t>(element_count());
  const std::size_t entries = static_cast<std::size_t>(dim() * dim());
  require(
      rotations.size() == count * entries,
      std::to_string(rotations.size()) + " entries of rotations for " + std::to_string(count) + " elements");
  require(weights.size() == count,
          std::to_string(weights.size()) + " weights for " + std::to_string(count) + " elements");
  for (std::size_t e = 0; e < count; ++e) {
    require(is_rotation(rotations.data() + e * entries, dim()),
            "the matrix of element " + std::to_string(e) + " is not a rotation");
    require(weights[e] > 0 && std::isfinite(weights[e]),
            "the weight of element " + std::to_string(e) + " is not positive");
  }
  for (std::size_t h = 0; h < targets.size(); ++h) {
    const Target& target = targets[h];
    const std::string name = "target " + std::to_string(h);
    require(target.node >= 0 && target.node < node_count(), name + ": node " + std::to_string(target.node) +
                                                                " is not among the " +
                                                                std::to_string(node_count()) + " there are");
    require(static_cast<int>(target.position.size()) == dim() && finite(target.position),
            name + ": position must be " + std::to_string(dim()) + " finite numbers");
  }
  require(alpha >= 0 && std::isfinite(alpha), "alpha must not be negative");
  require(incompressibility >= 0 && std::isfinite(incompressibility),
          "incompressibility must not be negative");
  require(margin >= 0 && std::isfinite(margin), "margin must not be negative");
  require(largest_stretch > margin, "largest_stretch must be above the margin");
  require(margin < 1,
          "a margin of " + to_text(margin) + " is not below 1, the least stretch of a body at rest");
  require_compatible_targets(*this);
  require_held_components(*this);
}

std::vector<double> unit_weights(const assembly::Elements& elements) {
  return std::vector<double>(static_cast<std::size_t>(elements.element_count()), 1.0);
}

std::vector<double> volume_weights(const assembly::Elements& elements) {
  std::vector<double> weights = elements.weights;
  const double mean =
      std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  for (double& weight : weights) weight /= mean;
  return weights;
}

}  // namespace isostretch::sdp_penalty

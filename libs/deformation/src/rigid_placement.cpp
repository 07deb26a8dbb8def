#include <isostretch/deformation/rigid_placement.hpp>
#include <isostretch/handles/elements.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::deformation {
namespace {

// Of every node, its part of the mean of the volumes around it in both key shapes.
std::vector<double> node_weights(const KeyShapes& key_shapes) {
  const assembly::Elements& elements = key_shapes.first.elements;
  const auto k = static_cast<std::size_t>(elements.nodes_per_element);
  const std::vector<double> a = key_shapes.first.volumes(), b = key_shapes.second.volumes();
  std::vector<double> weights(static_cast<std::size_t>(key_shapes.first.nodes.rows()), 0.0);
  for (std::size_t i = 0; i < elements.nodes.size(); ++i)
    weights[static_cast<std::size_t>(elements.nodes[i])] += a[i / k] + b[i / k];
  return weights;
}

}  // namespace

RigidPlacement::RigidPlacement(const KeyShapes& key_shapes)
    : dim_(key_shapes.first.dim),
      first_(key_shapes.first.rest_positions()),
      second_(key_shapes.second.rest_positions()) {
  find_components(key_shapes);
  for (Component& c : components_) {
    c.from = centroid(c.nodes, first_, dim_);
    c.to = centroid(c.nodes, second_, dim_);
  }
}

void RigidPlacement::find_components(const KeyShapes& key_shapes) {
  const std::vector<int> component = handles::component_of_nodes(key_shapes.first.elements);
  const std::vector<double> weights = node_weights(key_shapes);
  components_.resize(static_cast<std::size_t>(1 + *std::max_element(component.begin(), component.end())));
  double total = 0;
  for (std::size_t node = 0; node < component.size(); ++node) {
    if (component[node] < 0) {
      loose_.push_back(static_cast<int>(node));
      continue;
    }
    Component& c = components_[static_cast<std::size_t>(component[node])];
    c.nodes.nodes.push_back(static_cast<int>(node));
    c.nodes.weights.push_back(weights[node]);
    c.share += weights[node];
    total += weights[node];
  }
  for (Component& c : components_) {
    for (double& weight : c.nodes.weights) weight /= c.share;
    c.share /= total;
  }
}

Vector RigidPlacement::settled(Vector shape, const Vector& onto) const {
  for (const Component& c : components_)
    move(c.nodes, best_rotation(c.nodes, shape, onto, dim_), centroid(c.nodes, shape, dim_), c.from, shape);
  for (const int node : loose_) shape.segment(dim_ * node, dim_) = first_.segment(dim_ * node, dim_);
  return shape;
}

std::vector<Rotation> RigidPlacement::rotations_to_second(const Vector& last) const {
  std::vector<Rotation> result;
  for (const Component& c : components_) result.push_back(best_rotation(c.nodes, last, second_, dim_));
  return result;
}

Vector RigidPlacement::placed(double t, const Vector& settled, const std::vector<Rotation>& rotations) const {
  if (t == 0) return first_;
  if (t == 1) return second_;
  Vector result = settled;
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const Component& c = components_[i];
    move(c.nodes, share_of(rotations[i], t), c.from, (1 - t) * c.from + t * c.to, result);
  }
  for (const int node : loose_)
    result.segment(dim_ * node, dim_) =
        (1 - t) * first_.segment(dim_ * node, dim_) + t * second_.segment(dim_ * node, dim_);
  return result;
}

double RigidPlacement::distance(const Vector& a, const Vector& b) const {
  double sum = 0;
  for (const Component& c : components_)
    for (std::size_t i = 0; i < c.nodes.nodes.size(); ++i) {
      const int first = dim_ * c.nodes.nodes[i];
      sum += c.share * c.nodes.weights[i] * (a.segment(first, dim_) - b.segment(first, dim_)).squaredNorm();
    }
  return std::sqrt(sum);
}

}  // namespace isostretch::deformation

#include <isostretch/core/error.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/deformation/element_rotations.hpp>
#include <isostretch/handles/elements.hpp>
#include <isostretch/handles/rotation_blend.hpp>
#include <isostretch/handles/weights_cache.hpp>

#include <set>

namespace isostretch::deformation {
namespace {

void set_identity(double* rotation, int dim) {
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) rotation[i * dim + j] = i == j ? 1 : 0;
}

std::vector<bool> loose_elements(const HandleSet& handle_set, const SolidModel& body) {
  const std::vector<int> component = handles::component_of_nodes(body.elements);
  std::set<int> held;
  for (const int node : handle_set.nodes()) held.insert(component[static_cast<std::size_t>(node)]);
  const auto k = static_cast<std::size_t>(body.elements.nodes_per_element);
  std::vector<bool> loose;
  for (std::size_t first = 0; first < body.elements.nodes.size(); first += k)
    loose.push_back(!held.contains(component[static_cast<std::size_t>(body.elements.nodes[first])]));
  return loose;
}

}  // namespace

ElementRotations::ElementRotations(const ManipulationOptions& options, const SolidModel& body,
                                   const HandleSet& handle_set, const std::filesystem::path& cache,
                                   const Monitor& monitor)
    : body_(body), handle_set_(handle_set), blend_(options.blend), loose_(loose_elements(handle_set, body)) {
  if (options.rotations == Rotations::none) return;
  const ScopedTimer timer(seconds_);
  make_weights(cache, monitor);
  // Handles that this blend cannot mix are the scene's fault, not that of a frame.
  if (blend_ == handles::RotationBlend::angle && body.dim == 3) at(options.script.end);
}

void ElementRotations::make_weights(const std::filesystem::path& cache, const Monitor& monitor) {
  std::vector<std::vector<int>> nodes;
  for (const Handle& handle : handle_set_.handles()) {
    if (handle.nodes.empty()) throw Error(handle.path + ": all its vertices are in handles before");
    nodes.push_back(handle.nodes);
  }
  monitor.show("weights of the handles");
  if (cache.empty()) {
    weights_ = handles::bounded_biharmonic_weights(body_.elements, nodes);
  } else {
    handles::CachedWeights cached = handles::cached_weights(cache, body_.elements, nodes);
    weights_ = std::move(cached.weights);
    from_cache_ = cached.hit;
  }
}

std::vector<double> ElementRotations::at(double time) const {
  const auto count = static_cast<std::size_t>(body_.elements.element_count());
  const auto entries = static_cast<std::size_t>(body_.dim * body_.dim);
  std::vector<double> rotations;
  if (weights_) {
    std::vector<handles::AxisAngle> axis_angles;
    for (const Handle& handle : handle_set_.handles()) axis_angles.push_back(handle.motion.axis_angle(time));
    rotations = handles::blended_rotations(body_.elements, *weights_, axis_angles, blend_);
  } else {
    rotations.resize(count * entries);
  }
  for (std::size_t e = 0; e < count; ++e)
    if (!weights_ || loose_[e]) set_identity(rotations.data() + e * entries, body_.dim);
  return rotations;
}

}  // namespace isostretch::deformation

#include "rotations.hpp"

#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/timer.hpp>
#include <isostretch/handles/elements.hpp>
#include <isostretch/handles/rotation_blend.hpp>
#include <isostretch/handles/weights_cache.hpp>

#include <set>

namespace isostretch::app::manipulate {
namespace {

void set_identity(double* rotation, int dim) {
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) rotation[i * dim + j] = i == j ? 1 : 0;
}

std::vector<bool> loose_elements(const Rig& rig, const Body& body) {
  const std::vector<int> component = handles::component_of_nodes(body.elements);
  std::set<int> held;
  for (const int node : rig.nodes()) held.insert(component[static_cast<std::size_t>(node)]);
  const auto k = static_cast<std::size_t>(body.elements.nodes_per_element);
  std::vector<bool> loose;
  for (std::size_t first = 0; first < body.elements.nodes.size(); first += k)
    loose.push_back(!held.contains(component[static_cast<std::size_t>(body.elements.nodes[first])]));
  return loose;
}

}  // namespace

ElementRotations::ElementRotations(const Scene& scene, const Body& body, const Rig& rig,
                                   const std::filesystem::path& cache)
    : body_(body), rig_(rig), blend_(scene.blend), loose_(loose_elements(rig, body)) {
  if (scene.rotations == Rotations::none) return;
  const ScopedTimer timer(seconds_);
  make_weights(cache);
  // Handles that this blend cannot mix are the scene's fault, not that of a frame.
  if (blend_ == handles::RotationBlend::angle && body.dim == 3) at(scene.script.end);
}

void ElementRotations::make_weights(const std::filesystem::path& cache) {
  std::vector<std::vector<int>> nodes;
  for (const Handle& handle : rig_.handles()) {
    if (handle.nodes.empty()) throw Error(handle.path + ": all its vertices are in handles before");
    nodes.push_back(handle.nodes);
  }
  show_progress("weights of the handles");
  if (cache.empty()) {
    weights_ = handles::bounded_biharmonic_weights(body_.elements, nodes);
  } else {
    handles::CachedWeights cached = handles::cached_weights(cache, body_.elements, nodes);
    weights_ = std::move(cached.weights);
    from_cache_ = cached.hit;
  }
  clear_progress();
}

std::vector<double> ElementRotations::at(double time) const {
  const auto count = static_cast<std::size_t>(body_.elements.element_count());
  const auto entries = static_cast<std::size_t>(body_.dim * body_.dim);
  std::vector<double> rotations;
  if (weights_) {
    std::vector<handles::Turn> turns;
    for (const Handle& handle : rig_.handles()) turns.push_back(handle.motion.turn(time));
    rotations = handles::blended_rotations(body_.elements, *weights_, turns, blend_);
  } else {
    rotations.resize(count * entries);
  }
  for (std::size_t e = 0; e < count; ++e)
    if (!weights_ || loose_[e]) set_identity(rotations.data() + e * entries, body_.dim);
  return rotations;
}

}  // namespace isostretch::app::manipulate

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/handles/elements.hpp>

#include <algorithm>
#include <set>

namespace isostretch::deformation {
namespace {

bool is_rest(const handles::Transform& t) {
  return t.translation.isZero(0) && t.degrees == 0 && t.scale == 1;
}

// The motion, and before it the way from rest to where it begins.
std::vector<handles::Keyframe> from_rest(const std::vector<handles::Keyframe>& keys,
                                         const HandleScript& script) {
  const handles::Keyframe& first = keys.front();
  if (is_rest(first.transform)) return keys;
  std::vector<handles::Keyframe> result{{script.rest_time(), {}}};
  result[0].transform.axis = first.transform.axis;
  if (script.start < first.time) result.push_back({script.start, first.transform});
  result.insert(result.end(), keys.begin(), keys.end());
  return result;
}

Handle resolved(const HandleSpec& spec, const HandleScript& script, const handles::Nodes& nodes) {
  std::vector<int> chosen = handles::select(spec.select, nodes, spec.path + ".select");
  const handles::Point center = spec.center.value_or(handles::center_of(chosen, nodes));
  return {spec.path, spec.name, std::move(chosen),
          handles::Motion(from_rest(spec.keyframes, script), center, spec.path), spec.soft};
}

std::string called(const Handle& handle) {
  return handle.name == handle.path ? handle.path : handle.path + " (" + handle.name + ")";
}

}  // namespace

HandleSet::HandleSet(const HandleScript& script, const SolidModel& body) : nodes_(body.selectable()) {
  for (const HandleSpec& spec : script.handles) handles_.push_back(resolved(spec, script, nodes_));
  for (const HandleSpec& spec : script.handles)
    comes_from_rest_ = comes_from_rest_ || !is_rest(spec.keyframes.front().transform);
  share_nodes(script, 1e-12 * body.diagonal());
}

void HandleSet::share_nodes(const HandleScript& script, double tolerance) {
  std::vector<int> owner(static_cast<std::size_t>(nodes_.count()), -1);
  for (std::size_t h = 0; h < handles_.size(); ++h) {
    std::vector<int> own;
    for (const int node : handles_[h].nodes) {
      int& first = owner[static_cast<std::size_t>(node)];
      if (first >= 0)
        require_alike(handles_[static_cast<std::size_t>(first)], handles_[h], node, script, tolerance);
      else
        first = static_cast<int>(h), own.push_back(node);
    }
    handles_[h].nodes = std::move(own);
  }
}

void HandleSet::require_alike(const Handle& a, const Handle& b, int node, const HandleScript& script,
                              double tolerance) const {
  const std::string who = "vertex " + std::to_string(node) + " is in " + called(a) + " and in " + called(b);
  if (a.soft != b.soft) throw Error(who + ", which do not hold it alike: hard, or with which weight?");
  for (int frame = 0; frame <= script.frames; ++frame) {
    const double time = script.time(frame);
    if (!((target(a, node, time) - target(b, node, time)).norm() <= tolerance))
      throw Error(who + ", which move it to different places");
  }
}

std::vector<int> HandleSet::hard_nodes() const {
  std::vector<int> all;
  for (const Handle& handle : handles_)
    if (!handle.soft) all.insert(all.end(), handle.nodes.begin(), handle.nodes.end());
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<int> HandleSet::nodes() const {
  std::vector<int> all;
  for (const Handle& handle : handles_) all.insert(all.end(), handle.nodes.begin(), handle.nodes.end());
  std::sort(all.begin(), all.end());
  return all;
}

void HandleSet::place(double time, Vector& positions, bool soft_too) const {
  for (const Handle& handle : handles_) {
    if (handle.soft && !soft_too) continue;
    const handles::Placement placement = handle.motion.at(time);
    for (const int node : handle.nodes) {
      const handles::Point target = placement(nodes_.at(node));
      for (int i = 0; i < nodes_.dim; ++i) positions[nodes_.dim * node + i] = target[i];
    }
  }
}

std::vector<int> loose_components(const HandleSet& handle_set, const SolidModel& body) {
  const std::vector<int> component = handles::component_of_nodes(body.elements);
  std::set<int> held{-1};
  for (const int node : handle_set.nodes()) held.insert(component[static_cast<std::size_t>(node)]);
  std::vector<int> loose;
  for (std::size_t node = 0; node < component.size(); ++node)
    if (held.insert(component[node]).second) loose.push_back(static_cast<int>(node));
  return loose;
}

std::string loose_components_text(const std::vector<int>& loose) {
  if (loose.empty()) return {};
  std::string text = formatted(
      "%zu component(s) of the mesh have no handle and stay where they are, those of vertex", loose.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(loose.size(), 5); ++i)
    text.append(i > 0 ? ", " : " ").append(std::to_string(loose[i]));
  return text + (loose.size() > 5 ? ", ..." : "");
}

}  // namespace isostretch::deformation

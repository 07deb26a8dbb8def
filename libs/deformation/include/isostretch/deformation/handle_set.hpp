#pragma once

#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/deformation/solid_model.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

struct Handle {
  std::string path;  ///< in the scene, for messages
  std::string name;
  std::vector<int> nodes;  ///< ascending; a node that several handles move alike belongs to the first
  handles::Motion motion;
  std::optional<double> soft;  ///< weight
};

/// The handles of a scene on the nodes of a body.
class HandleSet {
 public:
  /// Throws Error naming the handle's path for selections without a node, and naming the node and both
  /// handles where two of them move a node to different places, or one hard and one soft.
  HandleSet(const HandleScript& script, const SolidModel& body);

  const std::vector<Handle>& handles() const { return handles_; }
  /// Some handle begins elsewhere than at rest: motions start at the scene's rest_time() then.
  bool comes_from_rest() const { return comes_from_rest_; }
  std::vector<int> hard_nodes() const;
  std::vector<int> nodes() const;

  /// Puts nodes of hard handles, or of all, where they have to be at that time.
  void place_hard(double time, Vector& positions) const { place(time, positions, false); }
  void place_all(double time, Vector& positions) const { place(time, positions, true); }

  handles::Point target(const Handle& handle, int node, double time) const {
    return handle.motion.at(time)(nodes_.at(node));
  }

 private:
  void place(double time, Vector& positions, bool soft_too) const;
  void share_nodes(const HandleScript& script, double tolerance);
  void require_alike(const Handle& a, const Handle& b, int node, const HandleScript& script,
                     double tolerance) const;

  handles::Nodes nodes_;
  std::vector<Handle> handles_;
  bool comes_from_rest_ = false;
};

/// Components of the body that no handle holds, each by its smallest node.
std::vector<int> loose_components(const HandleSet& handle_set, const SolidModel& body);
/// What to warn of then; empty where there are none.
std::string loose_components_text(const std::vector<int>& loose);

}  // namespace isostretch::deformation

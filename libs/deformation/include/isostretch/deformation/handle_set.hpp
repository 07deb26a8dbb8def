#pragma once

#include <isostretch/deformation/handle_script.hpp>
#include <isostretch/deformation/solid_model.hpp>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::deformation {

/// A handle on the nodes of a body.
struct Handle {
  std::string path;  ///< Place in the scene, for messages.
  std::string name;  ///< Name for users.
  /// Indices of nodes, ascending; a node that several handles move alike belongs to the first.
  std::vector<int> nodes;
  handles::Motion motion;      ///< Motion from the rest shape.
  std::optional<double> soft;  ///< Weight of a soft handle; none holds it hard.
};

/// The handles of a scene on the nodes of a body.
class HandleSet {
 public:
  /// Selects the nodes of the handles. Throws Error naming the handle's path for selections without a node,
  /// and naming the node and both handles where two of them move a node to different places, or one hard and
  /// one soft.
  HandleSet(const HandleScript& script, const SolidModel& body);

  /// Returns the handles.
  const std::vector<Handle>& handles() const { return handles_; }
  /// Returns whether some handle begins elsewhere than at rest: motions then start at the script's
  /// rest_time().
  bool comes_from_rest() const { return comes_from_rest_; }
  /// Returns the nodes of hard handles, ascending.
  std::vector<int> hard_nodes() const;
  /// Returns the nodes of all handles, ascending.
  std::vector<int> nodes() const;

  /// Puts the nodes of hard handles where they have to be at a time.
  void place_hard(double time, Vector& positions) const { place(time, positions, false); }
  /// Puts the nodes of all handles where they have to be at a time.
  void place_all(double time, Vector& positions) const { place(time, positions, true); }

  /// Returns the place where a node of a handle has to be at a time.
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

/// Returns the components of the body that no handle holds, each by its smallest node.
std::vector<int> loose_components(const HandleSet& handle_set, const SolidModel& body);
/// Returns a warning about components that no handle holds; empty where there are none.
std::string loose_components_text(const std::vector<int>& loose);

}  // namespace isostretch::deformation

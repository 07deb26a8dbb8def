#pragma once

#include <isostretch/core/monitor.hpp>
#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/deformation/manipulation_options.hpp>
#include <isostretch/handles/bounded_weights.hpp>

#include <filesystem>
#include <optional>
#include <vector>

namespace isostretch::deformation {

/// The ex-rotations of the elements, blended from the rotations of the handles.
class ElementRotations {
 public:
  /// Computes the handles' weights, or takes them from the folder `cache`. Body and handle set must outlive
  /// this object. Throws Error naming a handle that has no node left, and where the handles' axes differ and
  /// the blend needs one.
  ElementRotations(const ManipulationOptions& options, const SolidModel& body, const HandleSet& handle_set,
                   const std::filesystem::path& cache = {}, const Monitor& monitor = {});

  /// Returns the ex-rotations at a time, [element][dim * dim], column by column. Components without a handle
  /// have the identity. Throws Error naming the element where the handles' rotations cancel each other.
  std::vector<double> at(double time) const;

  /// Returns the weights of the handles; none where nothing is blended.
  const std::optional<handles::HandleWeights>& weights() const { return weights_; }
  /// Returns whether the weights were read from the cache.
  bool from_cache() const { return from_cache_; }
  /// Returns the seconds that the weights took.
  double seconds() const { return seconds_; }

 private:
  void make_weights(const std::filesystem::path& cache, const Monitor& monitor);

  const SolidModel& body_;
  const HandleSet& handle_set_;
  handles::RotationBlend blend_;
  std::vector<bool> loose_;  ///< Elements of components without a handle.
  std::optional<handles::HandleWeights> weights_;
  bool from_cache_ = false;
  double seconds_ = 0;
};

}  // namespace isostretch::deformation

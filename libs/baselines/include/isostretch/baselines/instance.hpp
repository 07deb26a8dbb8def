#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

namespace isostretch::baselines {

/// The input of every solver: the convex problem of inversion-free manipulation, and the body at rest, from
/// which methods start that cannot do without an inversion-free position.
struct Instance {
  /// The convex problem.
  sdp_penalty::Problem problem;
  Vector rest;  ///< dim entries a node; hard targets are not looked at

  /// Returns the dimension of the body, 2 or 3.
  int dim() const { return problem.dim(); }

  /// Throws Error naming what is at fault, as Problem::validate() does, and the element that is inverted or
  /// flat at rest.
  void validate() const;
};

}  // namespace isostretch::baselines

#pragma once

#include <isostretch/invariants/stretch.hpp>

#include <algorithm>

namespace isostretch::baselines {

// McAdams et al. 2011, "Efficient elasticity for character skinning with contact and collisions": of
// co-rotational elasticity only the change of the rotation can be indefinite; its part of the Hessian, the
// twists, is clamped, and nothing else needs to be looked at.
struct McAdamsRule {
  template <int Dim>
  void operator()(const invariants::PrincipalStretches<Dim, double>&,
                  invariants::StretchDerivatives<Dim, double>& d) const {
    for (int i = 0; i < d.pairs; ++i) d.twist[i] = std::max(0.0, d.twist[i]);
  }
};

}  // namespace isostretch::baselines

#pragma once

#include "first_order_driver.hpp"

#include <string>
#include <vector>

namespace isostretch::baselines {

// The local-global iteration for ARAP (Sorkine & Alexa 2007; Liu et al. 2008), x -> G(x):
//
//   local:   R = the rotation closest to F(x), at every quadrature point;
//   global:  G(x) = argmin over nodes that are not pinned of sum w |F - R|^2.
//
// The global system has the matrix of the metric, and on the right the rotations, less what the pinned nodes
// contribute to F. The metric's shift is a proximal term, shift / 2 |G(x) - x|^2, which keeps a body without
// pins in its place.
class LocalGlobal {
 public:
  explicit LocalGlobal(const DistortionProblem& problem);
  // Pinned nodes must be where they were at the first call.
  void apply(const Vector& x, SharedPieces& pieces, Vector& result);

 private:
  template <int Dim>
  void right_side(const Vector& x, const DirichletMetric& metric, Vector& right);
  template <int Dim>
  void local_step(const Vector& x);  // rotations_
  template <int Dim>
  void add_rotations(Vector& right) const;
  template <int Dim>
  void find_pull_of_pins();

  const assembly::Elements& elements_;
  std::size_t points_;
  // Entry e of point i at [e * points_ + i], column by column.
  std::vector<double> deformation_, rotations_;
  // Of the first x, for pins do not move: positions of pinned nodes, others zero; and what they take from the
  // right-hand side.
  Vector pins_alone_, pull_of_pins_;
};

// Why local-global is none for a problem; empty for ARAP.
std::string why_not_local_global(const DistortionProblem& problem);

// G(x) as a step from the iterate.
Step full_step_to(const Iterate& at, Vector next);

}  // namespace isostretch::baselines

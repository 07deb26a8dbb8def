#pragma once

#include <isostretch/baselines/distortion.hpp>

#include <cstddef>
#include <vector>

namespace isostretch::baselines {

// Corrects a direction p so that a full step does not invert elements to first order (Zhu, Bridson, Kaufman
// 2018): the p' next to p for which, at every quadrature point t,
//
//   a_t + grad a_t . p' >= 0,  a_t = det F_t above the bound of the energy,
//
// p' = p + sum_t lambda_t grad a_t with lambda >= 0 from at most 20 sweeps of projected Jacobi, damped by
// 1/2, from zero. Sweeps end early where the residual of complementarity (Fischer, Burmeister) stands still.
class DeterminantFilter {
 public:
  explicit DeterminantFilter(const DistortionProblem& problem);

  // False where p keeps all constraints and stays as it is.
  bool apply(const Vector& x, Vector& p);

  // a_t + grad a_t . p for all points.
  std::vector<double> linearized(const Vector& x, const Vector& p);

 private:
  const int* nodes_of(std::size_t point) const;
  template <int Dim>
  void linearize(const Vector& x);
  void evaluate(const Vector& p);  // constraints_
  double sweep();                  // multipliers_; the residual of complementarity before it
  void add_multiples(Vector& p) const;

  const assembly::Elements& elements_;
  double bound_;
  std::vector<bool> pinned_;  // nodes
  std::vector<double> determinants_;
  std::vector<double> rows_;  // grad a_t by the positions of the element's nodes: [point][node][dim]
  std::vector<double> squared_lengths_;
  std::vector<double> constraints_, multipliers_;
};

}  // namespace isostretch::baselines

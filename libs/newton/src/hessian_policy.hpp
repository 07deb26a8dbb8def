#pragma once

#include <isostretch/core/vector.hpp>
#include <isostretch/newton/options.hpp>
#include <isostretch/projection/filter.hpp>

#include <vector>

namespace isostretch::newton {

// Decides how much of which filter the next Hessian gets.
//
// The adaptive choice moves along one line: with weight s, a negative eigenvalue l becomes l (1 - 2 s), so
// that 0 is the exact Hessian, 1/2 clamps to zero, and 1 takes the absolute value (bounded: see
// projection::Filter::bounded_abs). Three rules move it:
//
// - Filtering costs the quadratic end phase wherever element Hessians are indefinite at the optimum although
//   their sum is not, while a Hessian that fails to factorise costs up to a factorization. Hence after a full
//   step the exact Hessian is tried (unless that step gained far more than promised, and there is no
//   barrier); if it fails, the weight that worked last is used, and the exact one is left alone for
//   retry_interval steps.
// - If it factorises but its model fits badly, which a short step shows, a quarter is used for as long.
// - From 1/2 on, a model that promised far more than the step gained goes to the absolute value, and one that
//   promised less comes back towards clamping. Energies with a barrier stay at 1/2: the barrier keeps steps
//   short enough, and absolute values make them needlessly short.
//
// docs/benchmarks/flattening.md and volumes.md have what this costs and saves.
class HessianPolicy {
 public:
  HessianPolicy(const Options& options, bool has_barrier)
      : options_(options), most_(has_barrier ? clamped : absolute), fallback_weight_(most_), weight_(most_) {}

  // The filter to try first at new positions.
  projection::FilterOptions first();
  // What to try after its factorization failed; false when nothing stronger is left.
  bool stronger(projection::FilterOptions& filter);
  // Learns from an accepted step: its length, and what the first one tried gained over what its model
  // promised.
  void step_taken(double step, double model_fit);

  // Whether the filter wants to know the gradient at the positions before the Hessian is made.
  bool by_residual() const { return options_.projection == Projection::progressive && share_ > 0; }
  // Restricts the filter to nodes with large entries of a gradient.
  void choose_nodes(const Vector& gradient, int dim, projection::FilterOptions& filter);

 private:
  static constexpr double exact = 0.0, clamped = 0.5, absolute = 1.0;

  projection::FilterOptions full(projection::Filter filter) const;
  projection::FilterOptions at(double weight);
  void adapt(double step, double model_fit);

  const Options& options_;
  const double most_;
  double fallback_weight_;  // between clamped and most_: what is used when the exact Hessian is not
  double weight_;           // the last that worked
  double tried_ = 0;
  int wait_ = 0;  // steps until the exact Hessian is tried again
  bool full_step_ = false;
  double model_fit_ = 0;  // of the last step; 0 before the first

  double share_ = 0;  // progressive: of the largest residual, above which elements are filtered; 0: all are
  std::vector<unsigned char> nodes_;
};

}  // namespace isostretch::newton

#pragma once

#include "newton_system.hpp"

#include <isostretch/newton/options.hpp>
#include <isostretch/newton/summary.hpp>

#include <limits>

namespace isostretch::newton {

// What can be told of an iterate by the scales of the problem: whether differences of energies mean anything,
// and whether it is a minimiser by scaled_gradient_tolerance.
//
// One median stiffness says little where elements differ by many orders of magnitude: a gradient small beside
// it must not promise a gain of energy either. So the test has two parts, and a gradient that passes the
// first waits for a decrement that can be trusted.
class ScaledGradientTest {
 public:
  ScaledGradientTest(const Options& options, const NewtonSystem& system, const Summary& summary)
      : options_(options), system_(system), summary_(summary) {}

  // Changes of the energy below this mean nothing: the rounding of a sum of many terms, a few units of
  // relative precision and never the worst case; and at rest, where the energy vanishes, of the positions.
  double energy_noise(const Vector& x) const;

  // At a new iterate. Returns whether it has converged: by the decrement of the step that led to it.
  bool passes(const Vector& x);
  // Whether the gradient has passed, and the decrement has yet to.
  bool awaits_decrement() const { return awaits_decrement_; }
  // Returns whether the iterate has converged by the decrement of the step from it, which was solved for as
  // accurately as wanted.
  bool passes_with(double decrement, const Vector& x) const {
    return awaits_decrement_ && promises_little(decrement, x);
  }

  // Of the Hessian last factorised: whether it was neither filtered nor shifted. One that was promises less
  // than there is.
  void set_exact_model(bool exact) { exact_model_ = exact; }
  // The decrement of an accepted step, which says something about its end only when it was a full one, solved
  // for accurately, of an exact model.
  void step_taken(double decrement, bool trusted) {
    last_decrement_ = exact_model_ && trusted ? decrement : std::numeric_limits<double>::infinity();
  }

 private:
  bool promises_little(double decrement, const Vector& x) const;
  double rounding_of_positions(const Vector& x) const;

  const Options& options_;
  const NewtonSystem& system_;
  const Summary& summary_;
  bool exact_model_ = false;
  bool awaits_decrement_ = false;
  double last_decrement_ = std::numeric_limits<double>::infinity();
};

}  // namespace isostretch::newton

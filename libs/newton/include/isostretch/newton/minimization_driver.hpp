#pragma once

#include <isostretch/core/iteration_driver.hpp>
#include <isostretch/newton/objective.hpp>
#include <isostretch/newton/options.hpp>
#include <isostretch/newton/solver.hpp>
#include <isostretch/newton/summary.hpp>

#include <string>

namespace isostretch::newton {

/// Does for a minimiser of an objective what all of them do around their steps: the tests of the start, of
/// the gradient and of the limits, in the words of Status, besides what IterationDriver does. For minimisers
/// of one's own: Solver has one.
///
/// What returns a bool returns whether the solve goes on, unless it says otherwise.
class MinimizationDriver : public IterationDriver<Summary> {
 public:
  /// The summary and the options must outlive the driver; of the options it takes gradient_tolerance, the
  /// limits and the token.
  MinimizationDriver(Summary& summary, const Options& options, const IterationCallback& callback);

  /// Ends the solve as failed_start where positions are not finite.
  bool begin(const Vector& x);
  /// Enters the energy at the start in the summary, and ends the solve as failed_start where it is not
  /// finite, naming the element.
  bool begin(const Evaluation& start);

  /// Adds the row of an iterate, whose energy and largest entry of the gradient it enters in the summary too.
  bool record(Iteration row, const Vector& x, double energy, const Vector& gradient);

  /// Ends the solve where there are no unknowns, and where the gradient is within gradient_tolerance.
  bool go_on_with_gradient(int unknowns);
  /// Ends the solve where the gradient is zero.
  bool go_on_with_slope();
  /// Ends the solve at the limits of iterations and of time.
  bool go_on_within_limits();

  /// Enters the total of seconds and the linear solver, which may be null, in the summary.
  void finish(const sparse::Solver* linear);

 private:
  Summary& summary_;
  const Options& options_;
};

}  // namespace isostretch::newton

#pragma once

#include "dirichlet_metric.hpp"

#include <isostretch/newton/line_search.hpp>

#include <memory>

namespace isostretch::baselines {

struct Iterate {
  Vector x;
  double energy = 0;
  Vector gradient;  // zero at pinned nodes
};

// The pieces that first-order methods share, timed and counted in a summary.
class SharedPieces {
 public:
  SharedPieces(const DistortionProblem& problem, newton::Summary& summary);

  newton::Objective& objective() { return *objective_; }
  DirichletMetric& metric() { return *metric_; }

  double value(const Vector& x);  // its count is the caller's: Iteration::evaluations
  newton::Evaluation differentiate(const Vector& x, Vector& gradient);
  sparse::FactorResult factorize();
  void solve(const Vector& right, Vector& direction);  // with the metric

  // Differences of energies below this mean nothing, as in newton::minimize, which has the stiffness of the
  // Hessian at hand; here it is that of the metric by the energy's shear modulus at rest.
  double noise(const Iterate& at) const;

  newton::Seconds& seconds() { return summary_.seconds; }

 private:
  const DistortionProblem& problem_;
  newton::Summary& summary_;
  double stiffness_;  // shear modulus of the energy at rest
  std::unique_ptr<newton::Objective> objective_;
  std::unique_ptr<DirichletMetric> metric_;
};

// What a method makes of an iterate: the next one, and the columns of the trace that it knows.
struct Step {
  bool taken = false;
  bool at_roundoff =
      false;  // taken although, or not taken because, the gain is below the rounding of energies
  Vector x;
  newton::Iteration row;
};

class FirstOrderMethod {
 public:
  virtual ~FirstOrderMethod() = default;
  virtual Step step(const Iterate& at, SharedPieces& pieces) = 0;
  // Forgets earlier iterates. False: there were none, and another step() would do the same again.
  virtual bool restart() { return false; }
};

// A step of line search from `from` along a direction; not taken when that does not descend.
Step search_step(const Iterate& from, const Vector& direction, const newton::Options& options,
                 SharedPieces& pieces);

// Runs a method from x, which ends as the last iterate. All stop alike: by the gradient at the iterates, for
// which one is evaluated in every iteration, also where the method itself has no use for it; by the limits;
// or where neither energy nor gradient improves any more. A step that fails is tried once more after a
// restart.
newton::Summary minimize_first_order(FirstOrderMethod& method, const DistortionProblem& problem, Vector& x,
                                     const MethodOptions& options, const newton::IterationCallback& callback);

}  // namespace isostretch::baselines

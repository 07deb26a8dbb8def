#pragma once

#include "path.hpp"

#include <memory>

namespace isostretch::sdp_penalty {

// An augmented Lagrangian of another shape: the penalty at multipliers U_i >= 0 and a parameter p that
// shrinks, of the constraint A_i = bound I - S_i <= 0.
class MultiplierPenalty : public ConePenalty {
 public:
  double parameter = 1;
  double bound = 0;
  virtual void set_multipliers(int dim, const Blocks& U) = 0;
  // The least parameter with which a matrix of this smallest eigenvalue is in the domain.
  virtual double least_parameter(double min_eigenvalue) const = 0;
};

// Of Spectral SDP and of PENNON.
std::unique_ptr<MultiplierPenalty> quadratic_log_penalty();
std::unique_ptr<MultiplierPenalty> reciprocal_penalty();

// The outer iteration that such methods have in common: minimise, take the penalty's multipliers, shrink the
// parameter where the violation has not fallen to a quarter.
void multiplier_method(Workspace& work, const Options& options, Progress& progress, Vector& x,
                       MultiplierPenalty& penalty);

}  // namespace isostretch::sdp_penalty
